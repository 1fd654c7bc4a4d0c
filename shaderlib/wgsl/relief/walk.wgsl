//! The exact walk over a quadtree of maxima: two loops, one direction, no step that depends on a rounded position.
//!
//! The ray is mirrored until it runs toward +x and +y, so that a step is always +1 and a parent's border is crossed exactly
//! where the far side of a node is also that of its parent. The state is the far sides of the node, whole numbers that f32
//! holds exactly, its level, and t. Every side's t is `side * inverse - origin * inverse`, the same for every level, so the
//! intervals that are passed over join without a gap; each step moves a side or a level, so no node is seen twice.
//! The inner loop only walks, the outer one intersects patches: lanes that run together wait for the slowest, and for both
//! sides of every branch.
//! Source: Tevs, Ihrke and Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering", I3D 2008; two loops after Aila and Laine, "Understanding the Efficiency of Ray Traversal on GPUs", HPG 2009.

/// A ray in the frame in which it runs toward +x and +y.
struct WalkFrame {
    /// -1 for an axis that is mirrored, else 0: cell c of this frame is cell c ^ mirror of the map.
    mirror: vec2i,
    /// The cell that the ray starts in.
    base: vec2i,
    /// Where in it; z in steps.
    origin: vec3f,
    /// How far 1 of t leads; x and y are positive.
    direction: vec3f,
    /// t per texel.
    inverse: vec2f,
    /// t of the base cell's near sides.
    before: vec2f,
    /// t per step of height, for a ray that falls.
    drop: f32,
    /// Where the ray ends.
    end: f32,
}

/// A node of the quadtree.
struct WalkNode {
    /// Its far sides, in texels from the base cell: whole numbers.
    sides: vec2f,
    /// Its side in texels.
    size: f32,
    /// log2 of that.
    level: i32,
}

/// How far a walk has come.
struct WalkState {
    /// Where it is.
    node: WalkNode,
    /// Before this t there is no hit.
    t: f32,
    /// Where the ray leaves the node.
    leave: f32,
    /// Nodes visited.
    steps: u32,
    /// Whether the node is a cell whose patch may be hit.
    stands: bool,
}

/// The first hit of a ray.
fn walk_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let frame = walk_frame(ray);
    var state = WalkState(walk_entry(frame, field), 0.0, 0.0, 0u, false);
    var leaves = 0u;
    loop {
        state = walk_to_cell(bounds, field, frame, state);
        if !state.stands {
            break;
        }
        leaves++;
        let sides = state.node.sides;
        let cell = frame.base + vec2i(sides) - 1i;
        let at = frame.origin + frame.direction * state.t;
        let corners = relief_corners(heights, field, cell, frame.mirror);
        let place = vec3f(at.xy - (sides - 1.0), at.z);
        let t = state.t + relief_patch(corners, place, frame.direction, state.leave - state.t);
        if t <= frame.end {
            return ReliefHit(t, RELIEF_HIT, cell ^ frame.mirror, state.steps, leaves);
        }
        state.t = state.leave;
        // The limit here as well: the inner loop ends at every cell that may be hit.
        if state.t >= frame.end || state.steps >= field.limit {
            break;
        }
        state.node = walk_next(frame, field, state.node, sides * frame.inverse + frame.before);
    }
    let outcome = select(RELIEF_UNRESOLVED, RELIEF_MISS, state.t >= frame.end);
    return ReliefHit(min(state.t, frame.end), outcome, vec2i(0), state.steps, leaves);
}

/// Walks until it stands on a cell that may be hit, is past the end, or has seen too many nodes.
fn walk_to_cell(bounds: texture_2d_array<u32>, field: ReliefField, frame: WalkFrame, start: WalkState) -> WalkState {
    let falls = frame.direction.z < 0.0;
    var state = start;
    loop {
        let node = state.node;
        let cell = (frame.base + vec2i(node.sides) - 1i) ^ frame.mirror;
        let bound = relief_bound(bounds, field, cell, node.level) + RELIEF_PAD;
        let reach = node.sides * frame.inverse + frame.before;
        state.leave = max(min(reach.x, reach.y), state.t);
        let lowest = frame.origin.z + frame.direction.z * select(state.t, state.leave, falls);
        let clear = lowest > bound;
        state.steps++;
        state.stands = !clear && node.level == 0i;
        if state.stands || state.steps >= field.limit {
            break;
        }
        // Both ways are worked out and one is taken: the lanes that run together need both anyway.
        let meets = clamp((bound - frame.origin.z) * frame.drop, state.t, state.leave);
        let enter = select(state.t, meets, falls);
        let down = walk_child(frame, node, enter);
        let on = walk_next(frame, field, node, reach);
        state.node = WalkNode(
            select(down.sides, on.sides, clear),
            select(down.size, on.size, clear),
            select(down.level, on.level, clear),
        );
        state.t = select(enter, state.leave, clear);
        // Not after a step down: what lies at the very end is still to be looked at.
        if clear && state.t >= frame.end {
            break;
        }
    }
    return state;
}

/// The node beyond the nearer side, or its parent where that side is one of the parent's.
fn walk_next(frame: WalkFrame, field: ReliefField, node: WalkNode, reach: vec2f) -> WalkNode {
    let along_x = reach.x <= reach.y;
    let inner = ((frame.base + vec2i(node.sides)) & vec2i(1i << u32(node.level))) != vec2i(0);
    let up = !select(inner.y, inner.x, along_x) && node.level < field.top;
    let moved = node.sides + node.size * select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), along_x);
    let wider = node.size * select(vec2f(0.0), vec2f(1.0), inner != vec2<bool>(along_x, !along_x));
    return WalkNode(
        select(moved, moved + wider, up),
        select(node.size, 2.0 * node.size, up),
        node.level + select(0i, 1i, up),
    );
}

/// The child that the ray is in at t.
fn walk_child(frame: WalkFrame, node: WalkNode, t: f32) -> WalkNode {
    let half = 0.5 * node.size;
    let middle = node.sides - half;
    let near = vec2f(t) < middle * frame.inverse + frame.before;
    return WalkNode(select(node.sides, middle, near), half, node.level - 1i);
}

/// The node around the base cell that is as large as the path is long.
fn walk_entry(frame: WalkFrame, field: ReliefField) -> WalkNode {
    let texels = u32(clamp(frame.end, 1.0, 65536.0));
    let level = min(i32(firstLeadingBit(texels)) + 1i, field.top);
    let shift = vec2u(u32(level));
    return WalkNode(vec2f((((frame.base >> shift) + 1i) << shift) - frame.base), f32(1i << u32(level)), level);
}

fn walk_frame(ray: ReliefRay) -> WalkFrame {
    let backward = ray.direction.xy < vec2f(0.0);
    let mirror = select(vec2i(0), vec2i(-1), backward);
    let direction = vec3f(max(abs(ray.direction.xy), vec2f(RELIEF_LEAST)), ray.direction.z);
    let origin = vec3f(select(ray.origin.xy, 1.0 - ray.origin.xy, backward), ray.origin.z);
    let inverse = 1.0 / direction.xy;
    let drop = 1.0 / select(-1.0, direction.z, direction.z < 0.0);
    return WalkFrame(mirror, ray.cell ^ mirror, origin, direction, inverse, -origin.xy * inverse, drop, ray.end);
}
