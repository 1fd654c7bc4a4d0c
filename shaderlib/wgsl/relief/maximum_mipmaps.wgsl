//! Maximum mipmaps, as published: one loop that goes down where the ray meets a node and on where it does not, and intersects
//! the patch of four texels at the finest level. The baseline of the exact methods.
//! Source: Tevs, Ihrke and Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering", I3D 2008, section 4.

/// The first hit of a ray.
fn maximum_mipmaps_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let direction = maximum_mipmaps_direction(ray);
    let inverse = 1.0 / direction.xy;
    let ahead = select(vec2i(0), vec2i(1), direction.xy > vec2f(0.0));
    var level = field.top;
    var node = ray.cell >> vec2u(u32(level));
    var t = 0.0;
    var leaves = 0u;
    for (var step = 1u; step <= field.limit; step++) {
        let shift = vec2u(u32(level));
        let bound = relief_bound(bounds, field, node << shift, level) + RELIEF_PAD;
        let reach = (vec2f(((node + ahead) << shift) - ray.cell) - ray.origin.xy) * inverse;
        let leave = clamp(min(reach.x, reach.y), t, ray.end);
        if ray.origin.z + direction.z * select(t, leave, direction.z < 0.0) <= bound {
            if level == 0i {
                leaves++;
                let place = ray.origin + direction * t - vec3f(vec2f(node - ray.cell), 0.0);
                let far = relief_patch(relief_corners(heights, field, node, vec2i(0)), place, direction, leave - t);
                if far < RELIEF_NEVER {
                    return ReliefHit(t + far, RELIEF_HIT, node, step, leaves);
                }
            } else {
                if direction.z < 0.0 {
                    t = clamp((bound - ray.origin.z) / direction.z, t, leave);
                }
                level--;
                let middle = ((2i * node + 1i) << vec2u(u32(level))) - ray.cell;
                let past = vec2f(t) >= (vec2f(middle) - ray.origin.xy) * inverse;
                node = 2i * node + select(vec2i(0), vec2i(1), past == (ahead > vec2i(0)));
                continue;
            }
        }
        t = leave;
        if t >= ray.end {
            return ReliefHit(ray.end, RELIEF_MISS, vec2i(0), step, leaves);
        }
        let left = node;
        node += select(vec2i(0, 1), vec2i(1, 0), reach.x < reach.y) * (2i * ahead - 1i);
        if any(((left ^ node) >> vec2u(1u)) != vec2i(0)) && level < field.top {
            level++;
            node = node >> vec2u(1u);
        }
    }
    return ReliefHit(t, RELIEF_UNRESOLVED, vec2i(0), field.limit, leaves);
}

/// The ray's direction, with no component so small that its inverse overflows.
fn maximum_mipmaps_direction(ray: ReliefRay) -> vec3f {
    let away = abs(ray.direction.xy) >= vec2f(RELIEF_LEAST);
    return vec3f(select(vec2f(RELIEF_LEAST), ray.direction.xy, away), ray.direction.z);
}
