//! The walk over a pyramid of sixteen children to a node, whose bounds are one load: the fewest loads, for devices where a load is
//! dear.
//!
//! As in `walk` the state is a whole cell, a level and t, but a level is a step of four, and a node is loaded once for as long as
//! the ray is among its children, and is kept while the ray is among those of one of them. Exact for the same reasons: the cell
//! only grows, or the level goes down; t only grows, by the sides of children that join without a gap; a bound is rounded up when
//! it is packed, so it is not under the surface; a child is passed over only where the ray stays RELIEF_PAD above it.
//! Nodes stand in one strip for all levels and mips: level 1 of the mip begins at `corner.x`, and each coarser level at a
//! sixteenth of the place of the finer, as it has a sixteenth of the nodes. The strip is broken into rows of 1024.
//! Source: Terrane; the walk after Tevs, Ihrke and Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering", I3D 2008.

/// How far it has come.
struct WideState {
    /// The cell that the ray is in at t.
    cell: vec2i,
    /// The level of the node around it, from 1: its children are 4^(level - 1) cells wide.
    level: i32,
    /// Before this t there is no hit.
    t: f32,
    /// Whether the child around the cell may be hit.
    meets: bool,
}

/// A node as it was loaded.
struct WideNode {
    /// Its column, row and level; no node has level 0.
    place: vec3i,
    /// Steps that all bounds of its children have in common.
    base: i32,
    /// log2 of the steps of height to a step of what they have besides.
    shift: u32,
    /// That, seven bits of each byte, a row of four to a word.
    children: vec4u,
}

/// The first hit of a ray.
fn wide_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let frame = walk_frame(ray);
    let entry = clamp(walk_entry(ray.end) / 2i, 1i, field.top);
    return wide_from(heights, bounds, field, frame, WideState(frame.base, entry, 0.0, false));
}

/// The same from where a ray has come to.
fn wide_from(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    frame: WalkFrame,
    start: WideState,
) -> ReliefHit {
    var state = start;
    var node = WideNode(vec3i(0i), 0i, 0u, vec4u(0u));
    // The one that the node was come down from, which the ray may soon be back in.
    var parent = node;
    var steps = 0u;
    var leaves = 0u;
    while steps < field.limit {
        let place = vec3i(state.cell >> vec2u(u32(2i * state.level)), state.level);
        if all(place == parent.place) {
            node = parent;
        } else if any(place != node.place) {
            if place.z < node.place.z {
                parent = node;
            }
            node = wide_node(bounds, field, state.cell ^ frame.mirror, place);
            steps++;
        }
        state = wide_children(frame, node, state);
        if state.meets && state.level == 1i {
            leaves++;
            let cell = WalkState(state.cell, 0i, state.t, steps, true, true);
            let t = walk_patch(frame, cell, relief_corners(heights, field, cell.cell, frame.mirror));
            if t <= frame.end {
                return ReliefHit(t, RELIEF_HIT, cell.cell ^ frame.mirror, steps, leaves);
            }
            state = wide_moved(field, state, walk_past(frame, field, cell));
        } else {
            state.level = clamp(state.level + select(1i, -1i, state.meets), 1i, field.top);
        }
        if !state.meets && state.t >= frame.end {
            return ReliefHit(frame.end, RELIEF_MISS, vec2i(0), steps, leaves);
        }
    }
    return ReliefHit(state.t, RELIEF_UNRESOLVED, vec2i(0), steps, leaves);
}

/// From child to child of a node until one may be hit, or the node or the ray's end is left behind.
fn wide_children(frame: WalkFrame, node: WideNode, start: WideState) -> WideState {
    let scale = u32(2i * start.level - 2i);
    let inner = vec2i((1i << scale) - 1i);
    var state = start;
    loop {
        let last = state.cell | inner;
        let reach = walk_reach(frame, last);
        let along_x = reach.x <= reach.y;
        let leave = select(reach.y, reach.x, along_x);
        let highest = wide_bound(node, (state.cell ^ frame.mirror) >> vec2u(scale));
        let bound = (frame.lid - highest) * frame.slowness;
        let clear = select(-state.t, leave, frame.falls) < bound;
        let on = select(bound, leave, clear);
        state.t = select(state.t, on, on > state.t);
        let next = walk_next(frame, state.cell, last, state.t, vec2<bool>(clear && along_x, clear && !along_x));
        let left = clear && (walk_beyond(last, along_x) & ((4i << scale) - 1i)) == 0i;
        state.cell = next;
        state.meets = !clear;
        if !clear || left || state.t >= frame.end {
            break;
        }
    }
    return state;
}

/// Behind a cell whose patch was not hit: in the same node, or in the parent of the next.
fn wide_moved(field: ReliefField, state: WideState, past: WalkState) -> WideState {
    let left = any((past.cell & vec2i(-4i)) != (state.cell & vec2i(-4i)));
    let level = select(1i, min(2i, field.top), left);
    return WideState(past.cell, level, past.t, false);
}

/// The node around a cell of the map, whose place in the frame is `place`. The high bits of its bytes are four of shift, and
/// twelve of base before them.
fn wide_node(bounds: texture_2d_array<u32>, field: ReliefField, cell: vec2i, place: vec3i) -> WideNode {
    let shift = u32(2i * place.z);
    let node = (cell & field.wrap) >> vec2u(shift);
    let index = (field.corner.x >> (2u * shift - 4u)) + (node.y << (u32(field.corner.y) - shift)) + node.x;
    let words = textureLoad(bounds, vec2i(index & 1023i, index >> 10u), field.layer, 0i);
    let high = (words >> vec4u(7u)) & vec4u(0x01010101u);
    let parts = (high | (high >> vec4u(7u)) | (high >> vec4u(14u)) | (high >> vec4u(21u))) & vec4u(15u);
    let base = parts.x | (parts.y << 4u) | (parts.z << 8u);
    return WideNode(place, i32(base) << u32(field.unit), parts.w, words);
}

/// The largest height over a child, in steps.
fn wide_bound(node: WideNode, child: vec2i) -> f32 {
    let rows = select(node.children.xy, node.children.zw, (child.y & 2i) != 0i);
    let row = select(rows.x, rows.y, (child.y & 1i) != 0i);
    let own = (row >> (8u * u32(child.x & 3i))) & 127u;
    return f32(node.base + i32((own + 1u) << node.shift));
}
