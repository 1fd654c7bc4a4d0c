//! Quadtree relief mapping, as published, and made exact. As published the ground is a box over each texel, a search goes down
//! but never up, and a border is passed by half a texel more than it is away. No guarantee: what is nearer to a border than that
//! is missed, and a ray along an axis never ends.
//! Source: Schröders and van Gulik, "Quadtree Relief Mapping", Graphics Hardware 2006, algorithm 1.

/// What is added to t at a border: half a texel, for a ray of which 1 of t leads a texel far.
const QUADTREE_RELIEF_DELTA: f32 = 0.5;

/// The place that the algorithm stops at, a hit unless the ray ends before; `bounds` over texels. The finest level that is read
/// is 0 by the text, 1 by the condition of the loop. A ray that does not come down is unresolved: the algorithm divides by its fall.
fn quadtree_relief_trace(bounds: texture_2d_array<u32>, field: ReliefField, ray: ReliefRay, finest: i32) -> ReliefHit {
    let start = vec2f(ray.cell & field.wrap) + ray.origin.xy + 0.5;
    let quadrant = select(vec2f(0.0), vec2f(1.0), ray.direction.xy > vec2f(0.0));
    let limit = select(0u, field.limit, ray.direction.z < 0.0);
    var level = field.top;
    var cursor = 0.0;
    for (var step = 1u; step <= limit; step++) {
        let at = start + ray.direction.xy * cursor;
        let height = relief_bound(bounds, field, vec2i(floor(at)), level);
        let t = (height - ray.origin.z) / ray.direction.z;
        let size = f32(1i << u32(level));
        let border = floor(at / size + quadrant) * size;
        let reach = quadtree_relief_quotient(border - start, ray.direction.xy);
        let leave = min(reach.x, reach.y) + QUADTREE_RELIEF_DELTA;
        cursor = max(cursor, min(t, leave));
        if cursor > ray.end {
            return ReliefHit(ray.end, RELIEF_MISS, vec2i(0), step, 0u);
        }
        level -= select(0i, 1i, t < leave);
        if level < finest {
            let cell = ray.cell + vec2i(floor(ray.origin.xy + ray.direction.xy * cursor));
            return ReliefHit(cursor, RELIEF_HIT, cell, step, 0u);
        }
    }
    return ReliefHit(cursor, RELIEF_UNRESOLVED, vec2i(0), limit, 0u);
}

/// A quotient where the divisor may be 0: as far back as can be, or as far on for 0 by 0, which Direct3D's minimum passes over.
fn quadtree_relief_quotient(over: vec2f, under: vec2f) -> vec2f {
    let none = under == vec2f(0.0);
    let far = select(vec2f(RELIEF_NEVER), vec2f(-RELIEF_NEVER), over < vec2f(0.0));
    return select(over / select(under, vec2f(1.0), none), far, none);
}

/// The first hit of a ray, in the same order of search; `bounds` over cells.
fn quadtree_relief_exact_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    return quadtree_trace(heights, bounds, field, ray, false);
}
