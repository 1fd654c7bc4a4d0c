//! From cone to cone with the least work to a load, for devices where arithmetic is dear: cones and patches are storage textures, a
//! cone and its tip are one word, and the four heights of a patch are one texel.
//!
//! It visits the cells that `robust_cone` visits, and is exact for the same reasons. Over a map that caches do not hold it begins
//! over coarse nodes, which they do hold, and stays there while a step leads far. A node's cone is that of a cell of a coarse
//! map above the surface, in a frame of nodes instead of cells: products with powers of two round nothing, and the place in the first
//! node by less than a cone is taken lower. Its tip is as high as all of the nodes around it, so that the cell at the last t may be off
//! by what rounding moves the ray, to either side.
//! Source: Terrane; see `robust_cone` and `sprint`. That empty space is crossed over coarser data first: Tevs, Ihrke and Seidel, I3D 2008.

/// The first hit of a ray. A texel of `patches` holds the four heights of a cell, two to a word; one of `cones` the height of its
/// highest corner and above that the code of its cone, and so for coarse nodes.
fn leap_trace(
    patches: texture_storage_2d_array<rg32uint, read>,
    cones: texture_storage_2d_array<r32uint, read>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let frame = walk_frame(ray);
    var state = RobustConeState(vec2f(1.0), 0.0, 0.0, 0u, false);
    if field.coarse.x >= 0i {
        state = leap_to_ground(cones, field, frame, state);
    }
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
    var goes_on = state.t <= frame.end;
    while goes_on {
        let cell = min((robust_cone_cell(frame, state.sides) ^ frame.mirror) & field.wrap, field.last);
        state = robust_cone_step(frame, state, leap_cone(cones, cell + field.patches, field.layer));
        goes_on = !state.stands && state.t < frame.end && state.steps < field.limit;
    }
    return state;
}

/// Goes from cone to cone over coarse nodes until a step leads no farther than LEAP_FAR, is past the end, or has seen too many.
fn leap_to_ground(
    cones: texture_storage_2d_array<r32uint, read>,
    field: ReliefField,
    frame: WalkFrame,
    start: RobustConeState,
) -> RobustConeState {
    let over = leap_over_nodes(frame);
    let shift = vec2u(RELIEF_COARSE);
    var state = start;
    var goes_on = true;
    while goes_on {
        let node = min((robust_cone_cell(over, state.sides) ^ frame.mirror) & (field.wrap >> shift), field.last >> shift);
        let before = state.t;
        state = robust_cone_step(over, state, leap_cone(cones, node + field.coarse, field.layer));
        goes_on = state.t - before > LEAP_FAR && state.t < frame.end && state.steps < field.limit;
    }
    // A ray that has not moved is still in its first cell, if at the very side of it.
    let sides = select(floor(frame.origin.xy + frame.direction.xy * state.t) + 1.0, start.sides, state.t == start.t);
    return RobustConeState(sides, state.t, state.t, state.steps, false);
}

/// Texels that a step over coarse nodes has to lead for another one to be worth its while.
const LEAP_FAR: f32 = 32.0;

/// The frame whose cells are coarse nodes. t stays as it is.
fn leap_over_nodes(frame: WalkFrame) -> WalkFrame {
    let shift = vec2u(RELIEF_COARSE);
    let side = f32(1i << RELIEF_COARSE);
    let base = frame.base >> shift;
    let origin = (frame.origin.xy + vec2f(frame.base - (base << shift))) / side;
    let inverse = frame.inverse * side;
    var over = frame;
    over.base = base;
    over.origin = vec3f(origin, frame.origin.z);
    over.direction = vec3f(frame.direction.xy / side, frame.direction.z);
    over.inverse = inverse;
    over.before = -origin * inverse;
    return over;
}

/// The cone of a cell or a node: the height of its tip, and how steep it is.
fn leap_cone(cones: texture_storage_2d_array<r32uint, read>, at: vec2i, layer: i32) -> vec2f {
    let word = textureLoad(cones, at, layer).r;
    return robust_cone_of(vec2u(word & 0xffffu, word >> 16u));
}
