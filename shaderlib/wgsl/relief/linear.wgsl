//! Linear search with a refinement: so many equal steps along the ray, then the place between the last two. No guarantee:
//! what is thinner than a step is missed.
//!
//! Two things differ from the published secant. The height under the entry is read; listing 1.1, as Tatarchuk's shader, takes
//! the ray to be on the surface there, and so places what is met in the first step at the entry. And a ray that meets nothing
//! is a miss, where the listing divides 0 by 0. The number of steps is the caller's: Tatarchuk's grows as the view is more
//! level. A step reads the four texels of the exact surface, where the published ones read a filtered texture once.
//! Source: Policarpo, Oliveira and Comba, "Real-Time Relief Mapping on Arbitrary Polygonal Surfaces", I3D 2005 (binary); Tatarchuk, "Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows", I3D 2006, and Drobot, GPU Pro 1, 2010, listing 1.1 (secant).

/// The first hit that linear search finds. `steps` is at least 1; `halvings` is 0 for one secant step, more for binary search.
fn linear_trace(
    heights: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    steps: u32,
    halvings: u32,
) -> ReliefHit {
    let stride = ray.end / f32(max(steps, 1u));
    var above = linear_gap(heights, field, ray, 0.0);
    for (var step = 1u; step <= steps; step++) {
        let t = stride * f32(step);
        let gap = linear_gap(heights, field, ray, t);
        if gap <= 0.0 {
            let found = linear_refined(heights, field, ray, vec2f(t - stride, t), vec2f(above, gap), halvings);
            let cell = ray.cell + vec2i(floor(ray.origin.xy + ray.direction.xy * found));
            return ReliefHit(found, RELIEF_HIT, cell, step + halvings + 1u, 0u);
        }
        above = gap;
    }
    return ReliefHit(ray.end, RELIEF_MISS, vec2i(0), steps + 1u, 0u);
}

/// The ray's height less the surface's.
fn linear_gap(heights: texture_2d_array<u32>, field: ReliefField, ray: ReliefRay, t: f32) -> f32 {
    let at = ray.origin + ray.direction * t;
    let whole = floor(at.xy);
    let part = at.xy - whole;
    let corners = relief_corners(heights, field, ray.cell + vec2i(whole), vec2i(0));
    return at.z - relief_height(corners, part);
}

/// The place between a point above the surface and one below it.
fn linear_refined(
    heights: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    bracket: vec2f,
    gaps: vec2f,
    halvings: u32,
) -> f32 {
    if halvings == 0u {
        return bracket.x + (bracket.y - bracket.x) * saturate(gaps.x / max(gaps.x - gaps.y, 1e-6));
    }
    var near = bracket.x;
    var far = bracket.y;
    for (var halving = 0u; halving < halvings; halving++) {
        let middle = 0.5 * (near + far);
        let under = linear_gap(heights, field, ray, middle) <= 0.0;
        near = select(middle, near, under);
        far = select(far, middle, under);
    }
    return far;
}
