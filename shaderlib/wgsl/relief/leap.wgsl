//! From cone to cone with one load to a cell: a texel holds all that a search asks of it, the cones toward four quadrants, their tip,
//! and the four heights of its patch.
//!
//! It visits the cells that `stride_quadrants` visits, and is exact for the same reasons. A GPU waits for what it loads, and in one
//! loop nearly every step meets a lane whose patch would be loaded after the cone; llvmpipe pays for every load, and for every loop.
//!
//! Over a map that caches do not hold it begins over coarse nodes, which they do hold, and stays there while a step leads far.
//! A node's cones are those of a cell of a coarse map above the surface, in a frame of nodes instead of cells: products with powers of
//! two round nothing, and the place in the first node by less than a cone is taken lower. Their tip is as high as all of the nodes
//! around it, so that the cell at the last t may be off by what rounding moves the ray, to either side.
//! Source: Terrane; see `robust_cone` and `stride_quadrants`. That empty space is crossed over coarser data first: Tevs, Ihrke and Seidel, I3D 2008.

/// The first hit of a ray.
fn leap_trace(cells: texture_2d_array<u32>, field: ReliefField, ray: ReliefRay) -> ReliefHit {
    let frame = walk_frame(ray);
    var state = RobustConeState(vec2f(1.0), 0.0, 0.0, 0u, false);
    if field.coarse.x >= 0i {
        state = leap_to_ground(cells, field, frame, state);
    }
    var leaves = 0u;
    var goes_on = state.t <= frame.end;
    while goes_on {
        let cell = robust_cone_cell(frame, state.sides) ^ frame.mirror;
        let texel = leap_texel(cells, field, min(cell & field.wrap, field.last) + field.patches);
        state = robust_cone_step(frame, state, stride_quadrants_of(texel.xy, frame.mirror));
        if state.stands {
            leaves++;
            let t = robust_cone_patch(frame, state, relief_mirrored(leap_corners(texel.zw), frame.mirror));
            if t <= frame.end {
                return ReliefHit(t, RELIEF_HIT, cell, state.steps, leaves);
            }
            state = robust_cone_past(frame, state);
        }
        goes_on = state.t < frame.end && state.steps < field.limit;
    }
    return robust_cone_over(frame, state, leaves);
}

/// Goes from cone to cone over coarse nodes until a step leads no farther than LEAP_FAR, is past the end, or has seen too many.
fn leap_to_ground(
    cells: texture_2d_array<u32>,
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
        let cone = stride_quadrants_of(leap_texel(cells, field, node + field.coarse).xy, frame.mirror);
        state = robust_cone_step(over, state, cone);
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

/// What is stored of a cell, or of a node: two words of cones, as `stride_quadrants_of` takes them, and two of heights.
fn leap_texel(cells: texture_2d_array<u32>, field: ReliefField, at: vec2i) -> vec4u {
    return textureLoad(cells, at, field.layer, 0i);
}

/// The four heights of a patch: at the corner, along x, along y, and both.
fn leap_corners(words: vec2u) -> vec4f {
    let low = words & vec2u(0xffffu);
    let high = words >> vec2u(16u);
    return vec4f(vec4u(low.x, high.x, low.y, high.y));
}
