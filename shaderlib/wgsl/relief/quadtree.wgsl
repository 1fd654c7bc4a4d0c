//! The exact search that the repaired quadtree methods share; not a method by itself. One loop: down where the ray meets a
//! node, on where it does not, and up after that, or not.
//!
//! A node is a whole number, and so is the last border that was crossed on each axis: a child before it is never chosen,
//! whatever rounding says of t. Each step on crosses a border beyond the last, and between two of them a search only goes down:
//! it ends, and no part of a ray is looked at twice on one level.
//! Source: Terrane, after Drobot, GPU Pro 1, 2010, listing 1.3, and Schröders and van Gulik, "Quadtree Relief Mapping", Graphics Hardware 2006, algorithm 1.

/// Farther than any border.
const QUADTREE_FAR: i32 = 0x1000000;

/// The first hit of a ray. After a border the search `rises` by a level, or stays on its own.
fn quadtree_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    rises: bool,
) -> ReliefHit {
    let direction = maximum_mipmaps_direction(ray);
    let inverse = 1.0 / direction.xy;
    let ahead = select(vec2i(0), vec2i(1), direction.xy > vec2f(0.0));
    let toward = 2i * ahead - 1i;
    var level = field.top;
    var node = ray.cell >> vec2u(u32(level));
    var crossed = -QUADTREE_FAR * toward;
    var t = 0.0;
    var leaves = 0u;
    for (var step = 1u; step <= field.limit; step++) {
        let bound = relief_bound(bounds, field, node << vec2u(u32(level)), level) + RELIEF_PAD;
        let border = ((node + ahead) << vec2u(u32(level))) - ray.cell;
        let reach = (vec2f(border) - ray.origin.xy) * inverse;
        let leave = clamp(min(reach.x, reach.y), t, ray.end);
        if ray.origin.z + direction.z * select(t, leave, direction.z < 0.0) <= bound {
            if level > 0i {
                if direction.z < 0.0 {
                    t = clamp((bound - ray.origin.z) / direction.z, t, leave);
                }
                level--;
                let middle = ((2i * node + 1i) << vec2u(u32(level))) - ray.cell;
                let past = vec2f(t) >= (vec2f(middle) - ray.origin.xy) * inverse;
                node = 2i * node + quadtree_child(past | ((crossed - middle) * toward >= vec2i(0)), ahead);
                continue;
            }
            leaves++;
            let far = quadtree_leaf(heights, field, ReliefRay(ray.cell, ray.origin, direction, leave), node, t);
            if far < RELIEF_NEVER {
                return ReliefHit(t + far, RELIEF_HIT, node, step, leaves);
            }
        }
        t = leave;
        if t >= ray.end {
            return ReliefHit(ray.end, RELIEF_MISS, vec2i(0), step, leaves);
        }
        let axis = select(vec2i(0, 1), vec2i(1, 0), reach.x < reach.y);
        crossed = select(crossed, border, axis == vec2i(1));
        let up = select(0i, 1i, rises && level < field.top);
        level += up;
        node = (node + axis * toward) >> vec2u(u32(up));
    }
    return ReliefHit(t, RELIEF_UNRESOLVED, vec2i(0), field.limit, leaves);
}

/// Which child of a node, where on each axis the ray is past the middle, and toward larger numbers if `ahead` is 1.
fn quadtree_child(past: vec2<bool>, ahead: vec2i) -> vec2i {
    return select(vec2i(0), vec2i(1), past == (ahead > vec2i(0)));
}

/// How far on from t a ray meets a cell's patch before its end, or RELIEF_NEVER.
fn quadtree_leaf(heights: texture_2d_array<u32>, field: ReliefField, ray: ReliefRay, cell: vec2i, t: f32) -> f32 {
    let place = ray.origin + ray.direction * t - vec3f(vec2f(cell - ray.cell), 0.0);
    return relief_patch(relief_corners(heights, field, cell, vec2i(0)), place, ray.direction, ray.end - t);
}
