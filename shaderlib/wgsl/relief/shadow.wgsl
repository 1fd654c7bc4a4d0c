//! What soft shadows and occlusion share; not a node.
//! Source: Terrane.

/// How much of a light is seen.
struct ShadowSeen {
    /// 0..1.
    share: f32,
    /// RELIEF_HIT, or RELIEF_UNRESOLVED where a limit was reached: then the share is at most this.
    state: u32,
    /// Nodes or samples read.
    steps: u32,
    /// Patches loaded: not the one that the ray starts over, which is given.
    leaves: u32,
}

/// The ray from a point of the surface to a light. `light` counts as positions do: x and y in texels, z in steps; its x and y
/// are not both 0. The ray starts `lift` steps above the patch, since the ground itself is in its own shadow: two are enough for
/// 16 bits, 1/128 for 8. It ends after `reach` texels. `own` are the heights of its cell.
fn shadow_ray(
    own: vec4f,
    field: ReliefField,
    cell: vec2i,
    place: vec2f,
    light: vec3f,
    lift: f32,
    reach: f32,
) -> ReliefRay {
    let height = relief_height(own, place);
    let direction = light / max(abs(light.x), abs(light.y));
    let ray = ReliefRay(cell, vec3f(place, height + lift), direction, reach / length(direction.xy));
    return ReliefRay(cell, ray.origin, direction, shadow_end(field, ray));
}

/// A ray that rises, up to where it leaves the highest height, `lid`.
fn shadow_under(ray: ReliefRay, lid: f32) -> ReliefRay {
    let rise = max(lid + 1.0 - ray.origin.z, 0.0) / max(ray.direction.z, 1e-6);
    return ReliefRay(ray.cell, ray.origin, ray.direction, min(ray.end, rise));
}

/// Where a ray ends on a map that ends: a little before the border, so that rounding does not lead beyond it.
fn shadow_end(field: ReliefField, ray: ReliefRay) -> f32 {
    // Whole texels by themselves: far from the first, f32 has no digits left for a part.
    let border = select(-ray.cell, field.last - ray.cell, ray.direction.xy > vec2f(0.0));
    let moves = abs(ray.direction.xy) > vec2f(RELIEF_LEAST);
    let way = (vec2f(border) - ray.origin.xy) / select(vec2f(1.0), ray.direction.xy, moves);
    let ends = select(vec2f(ray.end), clamp(way * 0.999998, vec2f(0.0), vec2f(ray.end)), moves & (field.wrap < vec2i(0)));
    return min(ends.x, ends.y);
}

/// The share of a disc of radius 1 that lies above a level line at a height of -1..1.
fn shadow_disc(line: f32) -> f32 {
    let x = clamp(-line, -1.0, 1.0);
    return 0.5 + (x * sqrt(1.0 - x * x) + asin(x)) * 0.318309886;
}
