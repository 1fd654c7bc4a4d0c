//! Soft shadow of parallax occlusion mapping: heights at equal steps along the ray to the light, and the one that reaches
//! farthest above the ray for its distance. What is thinner than a step casts no shadow, or one that flickers.
//! Source: Tatarchuk, "Practical Parallax Occlusion Mapping with Approximate Soft Shadows for Detailed Surface Rendering", ShaderX5, 2006, in the words of Drobot, GPU Pro 1, 2010, section 1.5.1; the published weights from her sample in the DirectX SDK (ParallaxOcclusionMapping, 2006), the others Terrane's.

/// The published solution: seven heights, the nearer ones counting more. `light` is the way over the ground in texels, the
/// sample's light vector times its height map's range, on which the ray is taken to rise by the whole height `lid`, whatever the
/// light's elevation. `softening` is the sample's, 0.58 where nothing is said. Of what is blocked three fifths count, as there;
/// what stands free of every height is brighter than 1 there, and 1 here.
fn shadow_soft_parallax_published(
    heights: texture_2d_array<u32>,
    field: ReliefField,
    cell: vec2i,
    place: vec2f,
    light: vec2f,
    softening: f32,
    lid: f32,
) -> ShadowSeen {
    let start = relief_mip_height(heights, field, cell, place, 0.0) / lid;
    var blocked = 0.0;
    for (var tap = 0u; tap < 7u; tap++) {
        let part = 0.22 + 0.11 * f32(tap);
        let weight = max(12.0 - 2.0 * f32(tap), 1.0);
        let height = relief_mip_height(heights, field, cell, place + part * light, 0.0) / lid;
        blocked = max(blocked, (height - start - part) * weight * softening);
    }
    return ShadowSeen(saturate(1.0 - 0.6 * blocked), RELIEF_HIT, 8u, 0u);
}

/// The share of a light whose radius has this tangent, by weights that are those of a disc. The ray starts above the ground, leads to the light's middle and ends
/// where it leaves the highest height; `steps` of height are as long as a texel is wide; `samples` is at least 1.
fn shadow_soft_parallax_share(
    heights: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    steps: f32,
    radius: f32,
    samples: u32,
) -> ShadowSeen {
    let unit = length(ray.direction.xy) * steps;
    let tangent = ray.direction.z / unit;
    // Steps across the light's radius, for each t.
    let spread = unit * radius * (1.0 + tangent * tangent);
    let stride = ray.end / f32(max(samples, 1u));
    var blocked = 0.0;
    for (var index = 1u; index <= samples; index++) {
        let t = stride * f32(index);
        let at = ray.origin + ray.direction * t;
        let surface = relief_mip_height(heights, field, ray.cell, at.xy, 0.0);
        blocked = max(blocked, (surface - at.z) / max(spread * t, 1e-6));
    }
    return ShadowSeen(1.0 - saturate(blocked), RELIEF_HIT, samples, 0u);
}
