//! The stride over cones that only what lies ahead narrows: four to a cell, one for each quadrant of directions, loaded at once.
//!
//! A tenth to three tenths fewer steps on rough ground than with one cone for all directions, for twice the memory. Exact for the reasons of
//! `robust_cone`: a ray stays in its quadrant.
//! Source: Terrane; see `robust_cone`; cones by sectors after Paglieroni, "The Directional Parameter Plane Transform of a Height Field", ACM Transactions on Graphics, 1998.

/// The first hit of a ray.
fn stride_quadrants_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let frame = walk_frame(ray);
    var state = RobustConeState(vec2f(1.0), 0.0, 0.0, 0u, false);
    var leaves = 0u;
    var goes_on = true;
    while goes_on {
        let cone = stride_quadrants_over(bounds, field, frame, robust_cone_cell(frame, state.sides));
        state = robust_cone_step(frame, state, cone);
        if state.stands {
            leaves++;
            let t = robust_cone_patch(heights, field, frame, state);
            if t <= frame.end {
                let cell = robust_cone_cell(frame, state.sides) ^ frame.mirror;
                return ReliefHit(t, RELIEF_HIT, cell, state.steps, leaves);
            }
            state = robust_cone_past(frame, state);
        }
        goes_on = state.t < frame.end && state.steps < field.limit;
    }
    let outcome = select(RELIEF_UNRESOLVED, RELIEF_MISS, state.t >= frame.end);
    return ReliefHit(min(state.t, frame.end), outcome, vec2i(0), state.steps, leaves);
}

/// The cone over a cell of the frame toward its ray: the height of its tip, and how steep it is.
fn stride_quadrants_over(bounds: texture_2d_array<u32>, field: ReliefField, frame: WalkFrame, cell: vec2i) -> vec2f {
    let texel = min((cell ^ frame.mirror) & field.wrap, field.last);
    let words = textureLoad(bounds, texel, field.layer, field.mip).rg;
    let word = select(words.x, words.y, frame.mirror.y != 0i);
    // Twelve bits toward larger x, twelve toward smaller: five of exponent, from 2^-14, and seven of mantissa.
    let code = (word >> (u32(frame.mirror.x) & 12u)) & 0xfffu;
    return vec2f(f32((words.x >> 24u) | ((words.y >> 24u) << 8u)), bitcast<f32>((code << 16u) + 0x38800000u));
}
