//! The exact walk over a quadtree of maxima: two loops, one direction, a whole cell as state.
//!
//! The ray is mirrored until it runs toward +x and +y. The state is the cell that the ray has come to, a whole number, a level,
//! and t. The node is the cell's ancestor at that level, so a step down changes the level alone, and a step across sets one
//! axis to the first cell beyond the node; the other axis, and both where the ray has come down to a bound inside the node, are
//! the cell at t, held between the cell it was and the last of the node. Why this is exact:
//! - No cell is seen twice: both axes of the cell only grow, and where neither does, the level has gone down.
//! - What is passed over joins without a gap: t only grows, and every node is looked at from the t at which the last was left,
//!   until the t of its own nearer far side, which is `side * inverse - origin * inverse` at every level.
//! - Rounding moves a side, or the cell at t, by no more than 2^-22 of the path; held between whole numbers it never skips a
//!   cell, and a patch is intersected over all of the t in which the ray is taken to be in its cell.
//! - A node is passed over only if the ray stays RELIEF_PAD above its bound, which is more than rounding moves it.
//! The inner loop only walks, the outer one intersects patches: lanes that run together wait for the slowest, and for both
//! sides of every branch.
//! Source: Terrane; the pyramid is that of Tevs, Ihrke and Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering", I3D 2008; two loops after Aila and Laine, "Understanding the Efficiency of Ray Traversal on GPUs", HPG 2009.

/// A ray in the frame in which it runs toward +x and +y.
struct WalkFrame {
    /// -1 for an axis that is mirrored, else 0: cell c of this frame is cell c ^ mirror of the map.
    mirror: vec2i,
    /// The cell that the ray starts in.
    base: vec2i,
    /// Where in it; z in steps.
    origin: vec3f,
    /// RELIEF_PAD under that.
    lid: f32,
    /// How far 1 of t leads; x and y are positive.
    direction: vec3f,
    /// t per texel.
    inverse: vec2f,
    /// t of the base cell's near sides.
    before: vec2f,
    /// t per step of height, whichever way.
    slowness: f32,
    /// Whether the ray comes down.
    falls: bool,
    /// Where the ray ends.
    end: f32,
}

/// How far it has come.
struct WalkState {
    /// The cell that the ray is in at t.
    cell: vec2i,
    /// log2 of the side of the node around it.
    level: i32,
    /// Before this t there is no hit.
    t: f32,
    /// Nodes visited.
    steps: u32,
    /// Whether the node is the cell itself and its patch may be hit.
    stands: bool,
    /// Whether there is nothing more to walk: it stands, is past the end, or has seen too many nodes.
    rests: bool,
}

/// The first hit of a ray.
fn walk_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let frame = walk_frame(ray);
    var state = WalkState(frame.base, min(walk_entry(ray.end), field.top), 0.0, 0u, false, false);
    var leaves = 0u;
    loop {
        state = walk_to_cell(bounds, field, frame, state);
        if !state.stands {
            break;
        }
        leaves++;
        let t = walk_patch(frame, state, relief_corners(heights, field, state.cell, frame.mirror));
        if t <= frame.end {
            return ReliefHit(t, RELIEF_HIT, state.cell ^ frame.mirror, state.steps, leaves);
        }
        state = walk_past(frame, field, state);
        // The limit here as well: the inner loop ends at every cell that may be hit.
        if state.t >= frame.end || state.steps >= field.limit {
            break;
        }
    }
    let outcome = select(RELIEF_UNRESOLVED, RELIEF_MISS, state.t >= frame.end);
    return ReliefHit(min(state.t, frame.end), outcome, vec2i(0), state.steps, leaves);
}

/// Goes on until it stands on a cell that may be hit, is past the end, or has seen too many nodes.
fn walk_to_cell(bounds: texture_2d_array<u32>, field: ReliefField, frame: WalkFrame, start: WalkState) -> WalkState {
    var state = start;
    loop {
        let highest = relief_bound(bounds, field, state.cell ^ frame.mirror, state.level);
        state = walk_step(frame, field, state, highest);
        if state.rests {
            break;
        }
    }
    return state;
}

/// From a node to the next, across or down. Where it stands it stays.
fn walk_step(frame: WalkFrame, field: ReliefField, state: WalkState, highest: f32) -> WalkState {
    let size = 1i << u32(state.level);
    let last = state.cell | vec2i(size - 1i);
    let reach = walk_reach(frame, last);
    let along_x = reach.x <= reach.y;
    let leave = select(reach.y, reach.x, along_x);
    // Where a ray that falls comes down to the bound; for one that rises, less the t at which it comes up to it.
    let bound = (frame.lid - highest) * frame.slowness;
    let clear = select(-state.t, leave, frame.falls) < bound;
    let on = select(bound, leave, clear);
    let t = select(state.t, on, on > state.t);
    let next = walk_next(frame, state.cell, last, t, vec2<bool>(clear && along_x, clear && !along_x));
    // The side of a node is one of its parent's where what lies beyond is the first half of another.
    let up = (walk_beyond(last, along_x) & size) == 0i && state.level < field.top;
    let is_cell = state.level == 0i;
    let level = state.level + select(select(-1i, 0i, is_cell), select(0i, 1i, up), clear);
    let steps = state.steps + 1u;
    // Not after a step down: what lies at the very end is still to be looked at.
    let rests = select(is_cell, t >= frame.end, clear) || steps >= field.limit;
    return WalkState(next, level, t, steps, !clear && is_cell, rests);
}

/// t of the far sides of a node, by its last cell.
fn walk_reach(frame: WalkFrame, last: vec2i) -> vec2f {
    return vec2f(last - frame.base + 1i) * frame.inverse + frame.before;
}

/// The cell at t, not before `cell` and not behind `last`, but for an axis that is crossed: there the first cell behind it.
fn walk_next(frame: WalkFrame, cell: vec2i, last: vec2i, t: f32, crossed: vec2<bool>) -> vec2i {
    let at = frame.base + vec2i(frame.origin.xy + frame.direction.xy * t);
    return max(select(cell, last + 1i, crossed), min(at, last));
}

/// The first column or row beyond a node, by its last cell.
fn walk_beyond(last: vec2i, along_x: bool) -> i32 {
    return select(last.y, last.x, along_x) + 1i;
}

/// t of the hit on the patch of the cell that it stands on, or RELIEF_NEVER and more.
fn walk_patch(frame: WalkFrame, state: WalkState, corners: vec4f) -> f32 {
    let near = vec3f(vec2f(state.cell - frame.base), 0.0);
    let place = frame.origin + frame.direction * state.t - near;
    return state.t + relief_patch(corners, place, frame.direction, walk_leave(frame, state) - state.t);
}

/// t of the nearer far side of the cell that it stands on.
fn walk_leave(frame: WalkFrame, state: WalkState) -> f32 {
    let reach = walk_reach(frame, state.cell);
    return max(min(reach.x, reach.y), state.t);
}

/// Behind the cell that it stands on.
fn walk_past(frame: WalkFrame, field: ReliefField, state: WalkState) -> WalkState {
    let reach = walk_reach(frame, state.cell);
    let along_x = reach.x <= reach.y;
    let leave = walk_leave(frame, state);
    let next = walk_next(frame, state.cell, state.cell, leave, vec2<bool>(along_x, !along_x));
    let up = (walk_beyond(state.cell, along_x) & 1i) == 0i && field.top > 0i;
    return WalkState(next, select(0i, 1i, up), leave, state.steps, false, false);
}

/// log2 of the side of a node that is as large as a path is long.
fn walk_entry(end: f32) -> i32 {
    return i32(firstLeadingBit(u32(clamp(end, 1.0, 65536.0)))) + 1i;
}

fn walk_frame(ray: ReliefRay) -> WalkFrame {
    let backward = ray.direction.xy < vec2f(0.0);
    let mirror = select(vec2i(0), vec2i(-1), backward);
    let direction = vec3f(max(abs(ray.direction.xy), vec2f(RELIEF_LEAST)), ray.direction.z);
    let origin = vec3f(select(ray.origin.xy, 1.0 - ray.origin.xy, backward), ray.origin.z);
    let inverse = 1.0 / direction.xy;
    return WalkFrame(
        mirror,
        ray.cell ^ mirror,
        origin,
        origin.z - RELIEF_PAD,
        direction,
        inverse,
        -origin.xy * inverse,
        1.0 / max(abs(direction.z), RELIEF_LEAST),
        direction.z < 0.0,
        ray.end,
    );
}
