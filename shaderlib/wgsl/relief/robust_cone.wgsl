//! Robust cones with an exact end: two loops, one that goes from cone to cone over cells, and one that intersects patches.
//!
//! A cell stores the height of its highest corner and the slope of a cone: from any point over the cell, that high, the cone
//! is free of the bilinear surface. The cone is square, as wide along the diagonal as its corners reach: with the larger of |x|
//! and |y| as the measure of t, how far a ray is across is t itself, and over most cells that distance is linear, as the
//! surface is, so that the bound is tight.
//!
//! Exact: where the ray is lower than the highest corner before it leaves the cell, its patch is intersected. Else the cell is
//! free, and so is the ray up to where it leaves the cone; the farther of both is the next t, and intervals join without a gap.
//! A cell's sides are whole numbers, and each step moves one of them on: to the neighbour beyond the nearer side or, if that is
//! farther, to the cell at t. That cell may be off by what rounding moves the ray, less than 2^-22 of t; a cone is taken as
//! much lower as it rises in that distance. Slopes are rounded up, and 2^-14 steeper than need be, which covers the step's own
//! rounding.
//! Source: Bán, Valasek, Bálint and Vad, "Robust Cone Step Mapping", EGSR 2024 (steps to the border of a cell, the smallest cone of the neighbours, conservative rounding); square cones over cells and the exact end: Terrane.

/// How far a walk has come.
struct RobustConeState {
    /// The far sides of the cell, in texels from the base cell: whole numbers.
    sides: vec2f,
    /// Before this t there is no hit.
    t: f32,
    /// Where the ray leaves the cell.
    leave: f32,
    /// Cells visited.
    steps: u32,
    /// Whether the cell's patch may be hit.
    stands: bool,
}

/// More than rounding moves a ray across, as a part of t: 2^-22.
const ROBUST_CONE_ROUNDING: f32 = 2.384185791015625e-7;

/// The first hit of a ray.
fn robust_cone_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let frame = walk_frame(ray);
    var state = RobustConeState(vec2f(1.0), 0.0, 0.0, 0u, false);
    var leaves = 0u;
    loop {
        state = robust_cone_to_cell(bounds, field, frame, state);
        if !state.stands {
            break;
        }
        leaves++;
        let corners = relief_corners(heights, field, robust_cone_cell(frame, state.sides), frame.mirror);
        let t = robust_cone_patch(frame, state, corners);
        if t <= frame.end {
            let cell = robust_cone_cell(frame, state.sides) ^ frame.mirror;
            return ReliefHit(t, RELIEF_HIT, cell, state.steps, leaves);
        }
        state = robust_cone_past(frame, state);
        if state.t >= frame.end {
            break;
        }
    }
    return robust_cone_over(frame, state, leaves);
}

/// The end of a search that has met nothing: past the end of the ray, or given up before.
fn robust_cone_over(frame: WalkFrame, state: RobustConeState, leaves: u32) -> ReliefHit {
    let outcome = select(RELIEF_UNRESOLVED, RELIEF_MISS, state.t >= frame.end);
    return ReliefHit(min(state.t, frame.end), outcome, vec2i(0), state.steps, leaves);
}

/// Goes from cone to cone until it stands on a cell that may be hit, is past the end, or has seen too many.
fn robust_cone_to_cell(
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    frame: WalkFrame,
    start: RobustConeState,
) -> RobustConeState {
    var state = start;
    // One way out, at the top: of lanes that leave from the middle, before others, Mesa 22.3's llvmpipe keeps a part of what they
    // had before.
    var goes_on = true;
    while goes_on {
        let texel = robust_cone_texel(bounds, field, frame, state.sides);
        state = robust_cone_step(frame, state, robust_cone_of(texel));
        goes_on = !state.stands && state.t < frame.end && state.steps < field.limit;
    }
    return state;
}

/// What is stored of the cell with these far sides.
fn robust_cone_texel(bounds: texture_2d_array<u32>, field: ReliefField, frame: WalkFrame, sides: vec2f) -> vec2u {
    let cell = robust_cone_cell(frame, sides) ^ frame.mirror;
    return textureLoad(bounds, min(cell & field.wrap, field.last), field.layer, field.mip).rg;
}

/// The cone of a texel: the height of its tip, and how steep it is.
fn robust_cone_of(cone: vec2u) -> vec2f {
    // Five bits of exponent, from 2^-14, and eleven of mantissa.
    return vec2f(f32(cone.x), bitcast<f32>((cone.y << 12u) + 0x38800000u));
}

/// From a cell to the next, or as far as its cone leads. Where its patch may be hit it stands.
fn robust_cone_step(frame: WalkFrame, state: RobustConeState, cone: vec2f) -> RobustConeState {
    let bound = cone.x + RELIEF_PAD;
    let slope = cone.y;
    let reach = state.sides * frame.inverse + frame.before;
    let leave = max(min(reach.x, reach.y), state.t);
    let gap = frame.origin.z + frame.direction.z * state.t - bound;
    let lowest = gap + frame.direction.z * select(0.0, leave - state.t, frame.falls);
    let stands = lowest <= 0.0;
    let free = gap - slope * ROBUST_CONE_ROUNDING * (state.t + 1.0);
    // A ray that rises as steeply as the cone never leaves it.
    let closing = max(slope * max(frame.direction.x, frame.direction.y) - frame.direction.z, 1e-6);
    let far = max(state.t + free / closing, leave);
    let at = floor(frame.origin.xy + frame.direction.xy * far) + 1.0;
    let sides = select(max(robust_cone_next(state.sides, reach), at), state.sides, stands);
    return RobustConeState(sides, select(far, state.t, stands), leave, state.steps + 1u, stands);
}

/// t of the hit on the patch of the cell that it stands on, or RELIEF_NEVER and more.
fn robust_cone_patch(frame: WalkFrame, state: RobustConeState, corners: vec4f) -> f32 {
    let at = frame.origin + frame.direction * state.t;
    let place = vec3f(at.xy - (state.sides - 1.0), at.z);
    return state.t + relief_patch(corners, place, frame.direction, state.leave - state.t);
}

/// Behind the cell that it stands on.
fn robust_cone_past(frame: WalkFrame, state: RobustConeState) -> RobustConeState {
    let sides = robust_cone_next(state.sides, state.sides * frame.inverse + frame.before);
    return RobustConeState(sides, state.leave, state.leave, state.steps, false);
}

/// The cell with these far sides, in the mirrored frame.
fn robust_cone_cell(frame: WalkFrame, sides: vec2f) -> vec2i {
    return frame.base + vec2i(sides) - 1i;
}

/// The far sides of the cell beyond the nearer side.
fn robust_cone_next(sides: vec2f, reach: vec2f) -> vec2f {
    return sides + select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), reach.x <= reach.y);
}
