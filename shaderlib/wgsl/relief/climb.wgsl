//! The walk of a ray that leaves the ground, or grazes it: from the finest node up. Not a node.
//!
//! It starts in the cell of its origin, whose patch is known and is looked at without asking for a bound, and goes up a level wherever it
//! crosses a border of the parent: no node is looked at that is larger than the way so far asks for. State, order and arithmetic
//! are those of `walk`; but for a ray that rises, it is where it enters a node that decides, so nothing is done about its exit.
//! Source: Terrane; after Tevs, Ihrke and Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering", I3D 2008.

/// A node of the quadtree.
struct ClimbNode {
    /// Its far sides, in texels from the base cell: whole numbers.
    sides: vec2f,
    /// Its side in texels.
    size: f32,
    /// log2 of that.
    level: i32,
}

/// How far a walk has come.
struct ClimbState {
    /// Where it is.
    node: ClimbNode,
    /// Before this t nothing is in the way.
    t: f32,
    /// Where the ray leaves the node.
    leave: f32,
    /// The largest height over the node, in steps; not asked for in the first cell.
    bound: f32,
    /// Nodes whose bounds were read.
    steps: u32,
    /// Whether something may be in the way in this node, and it is to be looked at as it is.
    stands: bool,
}

/// The start: in the first cell, up to its far side.
fn climb_start(frame: WalkFrame) -> ClimbState {
    let reach = frame.inverse + frame.before;
    return ClimbState(ClimbNode(vec2f(1.0), 1.0, 0i), 0.0, max(min(reach.x, reach.y), 0.0), 0.0, 0u, true);
}

/// The last cell of a node, in the frame: of a node of one cell, that cell.
fn climb_cell(frame: WalkFrame, node: ClimbNode) -> vec2i {
    return frame.base + vec2i(node.sides) - 1i;
}

/// Leaves the node, and walks until it stands in one where something may be in the way, is past the end, or has seen too many.
/// It stands in cells, and in nodes not larger than `coarse` times their t.
fn climb_on(bounds: texture_2d_array<u32>, field: ReliefField, frame: WalkFrame, start: ClimbState, coarse: f32) -> ClimbState {
    let falls = frame.direction.z < 0.0;
    var state = start;
    state.stands = false;
    state.t = start.leave;
    state.node = climb_next(frame, field, start.node, start.node.sides * frame.inverse + frame.before);
    // One way out, at the top: see `robust_cone`.
    while !state.stands && state.t < frame.end && state.steps < field.limit {
        let node = state.node;
        state.bound = relief_bound(bounds, field, climb_cell(frame, node) ^ frame.mirror, node.level);
        let reach = node.sides * frame.inverse + frame.before;
        state.leave = max(min(reach.x, reach.y), state.t);
        state.steps++;
        let lowest = frame.origin.z + frame.direction.z * select(state.t, state.leave, falls);
        let clear = lowest > state.bound + RELIEF_PAD;
        state.stands = !clear && (node.level == 0i || node.size <= coarse * state.t);
        let down = climb_child(frame, node, state.t);
        let on = climb_next(frame, field, node, reach);
        let moved = ClimbNode(
            select(down.sides, on.sides, clear),
            select(down.size, on.size, clear),
            select(down.level, on.level, clear),
        );
        state.node = ClimbNode(
            select(moved.sides, node.sides, state.stands),
            select(moved.size, node.size, state.stands),
            select(moved.level, node.level, state.stands),
        );
        state.t = select(state.t, state.leave, clear);
    }
    return state;
}

/// The node beyond the nearer side, or its parent where that side is one of the parent's.
fn climb_next(frame: WalkFrame, field: ReliefField, node: ClimbNode, reach: vec2f) -> ClimbNode {
    let along_x = reach.x <= reach.y;
    let inner = ((frame.base + vec2i(node.sides)) & vec2i(1i << u32(node.level))) != vec2i(0);
    let up = !select(inner.y, inner.x, along_x) && node.level < field.top;
    let moved = node.sides + node.size * select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), along_x);
    let wider = node.size * select(vec2f(0.0), vec2f(1.0), inner != vec2<bool>(along_x, !along_x));
    return ClimbNode(
        select(moved, moved + wider, up),
        select(node.size, 2.0 * node.size, up),
        node.level + select(0i, 1i, up),
    );
}

/// The child that the ray is in at t.
fn climb_child(frame: WalkFrame, node: ClimbNode, t: f32) -> ClimbNode {
    let half = 0.5 * node.size;
    let middle = node.sides - half;
    let near = vec2f(t) < middle * frame.inverse + frame.before;
    return ClimbNode(select(node.sides, middle, near), half, node.level - 1i);
}
