//! The fast horizon: few heights along the way to the light, farther ones from coarser mips. Cheap, and no bound of anything:
//! light leaks past what a mip has averaged away, and what is no blocker darkens.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro 1, 2010, section 1.5.2 and listing 1.4.

/// The published solution, five taps on one line. `light` is the way over the ground in texels: the listing's light vector times
/// its scale. Its minimum makes sense of depths only, so heights are read as depths below `lid`, 0..1: those of the taps are
/// multiplied by `weights`, the farthest first. `strength` is the listing's `selfShadowStrength`.
fn shadow_fast_horizon_published(
    heights: texture_2d_array<u32>,
    field: ReliefField,
    cell: vec2i,
    place: vec2f,
    light: vec2f,
    weights: array<f32, 5>,
    strength: f32,
    lid: f32,
) -> ShadowSeen {
    let start = 1.0 - relief_mip_height(heights, field, cell, place, 0.0) / lid;
    let far = 1.0 - relief_mip_height(heights, field, cell, place + 1.0 * light, 3.66) / lid;
    let fourth = 1.0 - relief_mip_height(heights, field, cell, place + 0.8 * light, 3.0) / lid;
    let third = 1.0 - relief_mip_height(heights, field, cell, place + 0.6 * light, 2.33) / lid;
    let second = 1.0 - relief_mip_height(heights, field, cell, place + 0.4 * light, 1.66) / lid;
    let near = 1.0 - relief_mip_height(heights, field, cell, place + 0.2 * light, 1.0) / lid;
    var least = min(1.0, weights[0] * far);
    least = min(least, weights[1] * fourth);
    least = min(least, weights[2] * third);
    least = min(least, weights[3] * second);
    least = min(least, weights[4] * near);
    return ShadowSeen(1.0 - saturate((start - least) * strength), RELIEF_HIT, 6u, 0u);
}

/// The general form: the profile in log n taps. Each is twice as far away as the one before and one mip coarser, so that its
/// texel covers the way in between. Gives rise over run of the steepest line to a tap, in steps for each t; with `taps` taps
/// the profile reaches 2^taps texels.
fn shadow_fast_horizon_slope(heights: texture_2d_array<u32>, field: ReliefField, ray: ReliefRay, taps: u32) -> f32 {
    var slope = -RELIEF_NEVER;
    var t = 1.5 / length(ray.direction.xy);
    for (var tap = 0u; tap < taps && t <= ray.end; tap++) {
        let height = relief_mip_height(heights, field, ray.cell, ray.origin.xy + ray.direction.xy * t, f32(tap));
        slope = max(slope, (height - ray.origin.z) / t);
        t *= 2.0;
    }
    return slope;
}

/// The share of a disc above that horizon. The ray leads to the disc's middle, `steps` of height are as long as a texel is wide,
/// `radius` is the tangent of the disc's.
fn shadow_fast_horizon_share(
    heights: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    steps: f32,
    radius: f32,
    taps: u32,
) -> ShadowSeen {
    let unit = length(ray.direction.xy) * steps;
    let tangent = ray.direction.z / unit;
    let slope = max(shadow_fast_horizon_slope(heights, field, ray, taps) / unit, 0.0);
    let line = (slope - tangent) / ((1.0 + slope * tangent) * radius);
    return ShadowSeen(shadow_disc(line), RELIEF_HIT, taps, 0u);
}
