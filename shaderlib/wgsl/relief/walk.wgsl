//! The exact walk over a quadtree of maxima: two loops, one direction, no step that depends on a rounded position.
//!
//! The ray is mirrored until it runs toward +x and +y, so that a step is always +1 and a parent's border is crossed exactly
//! where the far side of a node is also that of its parent. The state is the far sides of the node, whole numbers that f32
//! holds exactly, its level, and t. Every side's t is `side * inverse - origin * inverse`, the same for every level, so the
//! intervals that are passed over join without a gap; each step moves a side or a level, so no node is seen twice.
//! The inner loop only walks, the outer one intersects patches: lanes that run together wait for the slowest, and for both
//! sides of every branch.
//! Source: Tevs, Ihrke and Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering", I3D 2008; two loops after Aila and Laine, "Understanding the Efficiency of Ray Traversal on GPUs", HPG 2009.

/// The first hit of a ray.
fn walk_trace(
    heights: texture_2d<u32>,
    bounds: texture_2d<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let toward = ray.direction.xy < vec2f(0.0);
    let mirror = select(vec2i(0), vec2i(-1), toward);
    let direction = vec3f(max(abs(ray.direction.xy), vec2f(RELIEF_LEAST)), ray.direction.z);
    let origin = vec3f(select(ray.origin.xy, 1.0 - ray.origin.xy, toward), ray.origin.z);
    let base = ray.cell ^ mirror;
    let inverse = 1.0 / direction.xy;
    let before = -origin.xy * inverse;
    let falls = direction.z < 0.0;
    let drop = 1.0 / select(-1.0, direction.z, falls);

    var level = walk_entry(field, ray.end);
    var size = f32(1i << u32(level));
    var sides = vec2f((((base >> vec2u(u32(level))) + 1i) << vec2u(u32(level))) - base);
    var t = 0.0;
    var leave = 0.0;
    var steps = 0u;
    var leaves = 0u;
    loop {
        var stands = false;
        loop {
            let last = base + vec2i(sides);
            let bound = relief_bound(bounds, field, (last - 1i) ^ mirror, level) + RELIEF_PAD;
            let reach = sides * inverse + before;
            leave = max(min(reach.x, reach.y), t);
            let lowest = origin.z + direction.z * select(t, leave, falls);
            let clear = lowest > bound;
            stands = !clear && level == 0i;
            steps++;
            if stands || steps >= field.limit {
                break;
            }
            // Down: to where the ray meets the bound, into the child there.
            let half = 0.5 * size;
            let enter = select(t, clamp((bound - origin.z) * drop, t, leave), falls);
            let middle = sides - half;
            let child = select(sides, middle, vec2f(enter) < middle * inverse + before);
            // On: over the nearer side, and up where that is a side of the parent too.
            let along_x = reach.x <= reach.y;
            let inner = (last & vec2i(1i << u32(level))) != vec2i(0);
            let up = !select(inner.y, inner.x, along_x) && level < field.top;
            let moved = sides + size * select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), along_x);
            let wider = size * select(vec2f(0.0), vec2f(1.0), inner != vec2<bool>(along_x, !along_x));
            let next = select(moved, moved + wider, up);

            t = select(enter, leave, clear);
            sides = select(child, next, clear);
            size = select(half, select(size, 2.0 * size, up), clear);
            level += select(-1i, select(0i, 1i, up), clear);
            // Not after a step down: what lies at the very end is still to be looked at.
            if clear && t >= ray.end {
                break;
            }
        }
        if !stands {
            let state = select(RELIEF_UNRESOLVED, RELIEF_MISS, t >= ray.end);
            return ReliefHit(min(t, ray.end), state, vec2i(0), steps, leaves);
        }
        leaves++;
        let cell = vec2i(sides) - 1i;
        let place = vec3f(origin.xy + direction.xy * t - (sides - 1.0), origin.z + direction.z * t);
        let corners = relief_corners(heights, field, base + cell, mirror);
        let far = relief_patch(corners, place, direction, leave - t);
        if far < RELIEF_NEVER && t + far <= ray.end {
            return ReliefHit(t + far, RELIEF_HIT, (base + cell) ^ mirror, steps, leaves);
        }
        t = leave;
        if t >= ray.end {
            return ReliefHit(ray.end, RELIEF_MISS, vec2i(0), steps, leaves);
        }
        let reach = sides * inverse + before;
        let along_x = reach.x <= reach.y;
        let inner = ((base + vec2i(sides)) & vec2i(1i)) != vec2i(0);
        let up = !select(inner.y, inner.x, along_x) && 0i < field.top;
        let wider = select(vec2f(0.0), vec2f(1.0), inner != vec2<bool>(along_x, !along_x));
        sides += select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), along_x) + select(vec2f(0.0), wider, up);
        size = select(1.0, 2.0, up);
        level = select(0i, 1i, up);
    }
    return ReliefHit(ray.end, RELIEF_UNRESOLVED, vec2i(0), steps, leaves);
}

/// The level at which a search begins: nodes as large as the path is long.
fn walk_entry(field: ReliefField, path: f32) -> i32 {
    let texels = u32(clamp(path, 1.0, 65536.0));
    return min(i32(firstLeadingBit(texels)) + 1i, field.top);
}
