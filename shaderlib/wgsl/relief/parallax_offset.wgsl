//! Parallax mapping with offset limiting: one reading where the ray enters, and a shift along the view by the depth that was
//! read. No guarantee: it is right where the ground lies at the height at which the ray starts.
//! Source: Kaneko et al., "Detailed Shape Representation with Parallax Mapping", ICAT 2001; Welsh, "Parallax Mapping with Offset Limiting: A Per-Pixel Approximation of Uneven Surfaces", 2004 (the limit).

/// The place that one reading gives, always a hit. A texel is as wide as `steep` steps are high.
fn parallax_offset_trace(heights: texture_2d_array<u32>, field: ReliefField, ray: ReliefRay, steep: f32) -> ReliefHit {
    let depth = linear_gap(heights, field, ray, 0.0) / steep;
    let view = vec3f(ray.direction.xy, ray.direction.z / steep);
    // The limit: divided by the length of the view, not by how far it falls, the shift is never more than the depth.
    let t = clamp(depth / max(length(view), RELIEF_LEAST), 0.0, ray.end);
    let cell = ray.cell + vec2i(floor(ray.origin.xy + ray.direction.xy * t));
    return ReliefHit(t, RELIEF_HIT, cell, 1u, 0u);
}
