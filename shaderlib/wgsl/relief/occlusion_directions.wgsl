//! Ambient occlusion: the share of an even sky's light that reaches a surface, by horizons in evenly spaced directions.
//!
//! It is (1/π) ∫ n·ω dω over the directions above the surface, above the horizon and above the plane of the map. In a vertical
//! plane that is an integral over elevations, known in closed form; the directions are summed. The published method takes 4 or
//! 8, or fewer that are turned from pixel to pixel: `turn` is an angle, any part of a step.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro 1, 2010, section 1.6 (directions, jitter); the horizons of `horizon` or of his listing 1.4; the integral Terrane's, after Max, "Horizon mapping", The Visual Computer 1988.

/// By exact horizons. Of the ray only its start, above the ground, and its end count: no land beyond that t hides the sky.
/// `normal` is the surface's, z up, of length 1; `steps` of height are as long as a texel is wide; no texel is above `lid`. The
/// tangent of a horizon may be too small by `tolerance`. `own` are the heights of the cell that it starts in.
fn occlusion_directions_search(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    own: vec4f,
    normal: vec3f,
    steps: f32,
    turn: f32,
    lid: f32,
    directions: u32,
    tolerance: f32,
) -> ShadowSeen {
    var seen = ShadowSeen(0.0, RELIEF_HIT, 0u, 0u);
    for (var index = 0u; index < directions; index++) {
        let angle = turn + f32(index) * (6.28318531 / f32(directions));
        let way = vec2f(cos(angle), sin(angle));
        let along = dot(normal.xy, way);
        let least = max(-along / max(normal.z, 1e-6), 0.0);
        let scale = 1.0 / max(abs(way.x), abs(way.y));
        let sight = ReliefRay(ray.cell, ray.origin, vec3f(way, least * steps) * scale, ray.end);
        let sent = ReliefRay(ray.cell, ray.origin, sight.direction, shadow_end(field, sight));
        let passed = tolerance * steps * scale;
        let found = horizon_search(heights, bounds, field, sent, own, RELIEF_NEVER, lid, 0.0, passed);
        seen.share += occlusion_directions_wedge(along, normal.z, found.slope / (steps * scale));
        seen.state = select(RELIEF_UNRESOLVED, seen.state, found.done);
        seen.steps += found.steps;
        seen.leaves += found.leaves;
    }
    seen.share = saturate(seen.share / f32(max(directions, 1u)));
    return seen;
}

/// By so many taps of the fast horizon in each direction.
fn occlusion_directions_fast(
    heights: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    normal: vec3f,
    steps: f32,
    turn: f32,
    directions: u32,
    taps: u32,
) -> ShadowSeen {
    var share = 0.0;
    for (var index = 0u; index < directions; index++) {
        let angle = turn + f32(index) * (6.28318531 / f32(directions));
        let way = vec2f(cos(angle), sin(angle));
        let along = dot(normal.xy, way);
        let sight = ReliefRay(ray.cell, ray.origin, vec3f(way, 0.0), ray.end);
        let slope = shadow_fast_horizon_slope(heights, field, sight, taps) / steps;
        share += occlusion_directions_wedge(along, normal.z, max(slope, max(-along / max(normal.z, 1e-6), 0.0)));
    }
    return ShadowSeen(saturate(share / f32(max(directions, 1u))), RELIEF_HIT, directions * taps, 0u);
}

/// Twice ∫ (along cos e + up sin e) cos e de from a horizon to the zenith; `slope` is the horizon's tangent, not below 0.
fn occlusion_directions_wedge(along: f32, up: f32, slope: f32) -> f32 {
    let square = 1.0 / (1.0 + slope * slope);
    return along * (1.57079633 - atan(slope) - slope * square) + up * square;
}
