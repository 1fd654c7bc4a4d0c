//! From cone to cone with the least work to a load, for devices where arithmetic is dear: cones and patches are storage textures, a
//! cone and its tip are one word, and the four heights of a patch are one texel.
//!
//! It visits the cells that `robust_cone` visits, and is exact for the same reasons.
//! Source: Terrane; see `robust_cone` and `sprint`.

/// The first hit of a ray. A texel of `patches` holds the four heights of a cell, two to a word; one of `cones` the height of its
/// highest corner and above that the code of its cone.
fn leap_trace(
    patches: texture_storage_2d_array<rg32uint, read>,
    cones: texture_storage_2d_array<r32uint, read>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let frame = walk_frame(ray);
    var state = RobustConeState(vec2f(1.0), 0.0, 0.0, 0u, false);
    var leaves = 0u;
    loop {
        state = leap_to_cell(cones, field, frame, state);
        if !state.stands {
            break;
        }
        leaves++;
        let cell = robust_cone_cell(frame, state.sides);
        let t = robust_cone_patch(frame, state, sprint_corners(patches, field, cell, frame.mirror));
        if t <= frame.end {
            return ReliefHit(t, RELIEF_HIT, cell ^ frame.mirror, state.steps, leaves);
        }
        state = robust_cone_past(frame, state);
        if state.t >= frame.end {
            break;
        }
    }
    return robust_cone_over(frame, state, leaves);
}

/// Goes from cone to cone until it stands on a cell that may be hit, is past the end, or has seen too many.
fn leap_to_cell(
    cones: texture_storage_2d_array<r32uint, read>,
    field: ReliefField,
    frame: WalkFrame,
    start: RobustConeState,
) -> RobustConeState {
    var state = start;
    // One way out, at the top: see `robust_cone`.
    var goes_on = true;
    while goes_on {
        let cell = min((robust_cone_cell(frame, state.sides) ^ frame.mirror) & field.wrap, field.last);
        let word = textureLoad(cones, cell + field.patches, field.layer).r;
        state = robust_cone_step(frame, state, robust_cone_of(vec2u(word & 0xffffu, word >> 16u)));
        goes_on = !state.stands && state.t < frame.end && state.steps < field.limit;
    }
    return state;
}
