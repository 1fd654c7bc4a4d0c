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
    /// Patches looked at.
    leaves: u32,
}

/// The ray from a point of the surface to a light. `light` counts as positions do: x and y in texels, z in steps; its x and y
/// are not both 0. The ray starts `lift` steps above the patch: two are enough for 16 bits, 1/128 for 8. It ends where it
/// leaves the highest of the heights, `lid`, and after `reach` texels.
fn shadow_ray(
    heights: texture_2d<u32>,
    field: ReliefField,
    cell: vec2i,
    place: vec2f,
    light: vec3f,
    lift: f32,
    lid: f32,
    reach: f32,
) -> ReliefRay {
    let corners = relief_corners(heights, field, cell, vec2i(0));
    let height = mix(mix(corners.x, corners.y, place.x), mix(corners.z, corners.w, place.x), place.y) + lift;
    let direction = light / max(abs(light.x), abs(light.y));
    let rise = max(lid + 1.0 - height, 0.0) / max(direction.z, 1e-6);
    let ray = ReliefRay(cell, vec3f(place, height), direction, min(rise, reach / length(direction.xy)));
    return ReliefRay(cell, ray.origin, direction, shadow_end(field, ray));
}

/// Where a ray ends on a map that ends: a little before the border, so that rounding does not lead beyond it.
fn shadow_end(field: ReliefField, ray: ReliefRay) -> f32 {
    let start = vec2f(ray.cell) + ray.origin.xy;
    let far = select(vec2f(0.0), vec2f(field.last), ray.direction.xy > vec2f(0.0));
    let way = max((far - start) / select(vec2f(RELIEF_LEAST), ray.direction.xy, abs(ray.direction.xy) > vec2f(RELIEF_LEAST)), vec2f(0.0));
    let ends = select(vec2f(ray.end), min(way, vec2f(ray.end)), field.wrap < vec2i(0));
    return min(ends.x, ends.y);
}

/// The share of a disc of radius 1 that lies above a level line at a height of -1..1.
fn shadow_disc(line: f32) -> f32 {
    let x = clamp(-line, -1.0, 1.0);
    return 0.5 + (x * sqrt(1.0 - x * x) + asin(x)) * 0.318309886;
}
