//! Materials with relief: the eye's ray goes on under the ground until it meets one of them.

/// What the eye's ray met under a place.
struct HostTraced {
    /// The place whose material is seen, moved along the ground.
    frame: HostFrame,
    relief: TerrainRelief,
    hit: DisplacedHit,
    /// From the first place to what was met, in metres along the ground's tangent, bitangent and normal.
    point: vec3f,
    /// The same in the world.
    moved: vec3f,
    /// The ground's axes, in the world.
    tangent: vec3f,
    bitangent: vec3f,
}

/// Sine of the lowest angle at which a ray goes into the ground: a smooth normal may turn away from the eye before the
/// ground does.
const HOST_GRAZING: f32 = 0.02;

/// A vector of the world in the axes of the ground.
fn host_in_ground(traced: HostTraced, way: vec3f) -> vec3f {
    return vec3f(dot(way, traced.tangent), dot(way, traced.bitangent), dot(way, traced.frame.normal));
}

/// Follows the eye's ray from the ground to its relief. `extent` is the metres over all of `terrain_uv`, on x and z.
fn host_traced(frame: HostFrame, to_eye: vec3f, extent: vec2f) -> HostTraced {
    let tangent = normal_to_world(vec3f(1.0, 0.0, 0.0), frame.normal);
    let bitangent = normal_to_world(vec3f(0.0, 1.0, 0.0), frame.normal);
    let pixel = 2.0 * length(host_view.right) / host_view.pixels.x * frame.distance;
    let relief = terrane_ground(frame, tangent, bitangent, pixel);
    var traced = HostTraced(frame, relief, DisplacedHit(0.0, 0u, true), vec3f(0.0), vec3f(0.0), tangent, bitangent);
    if relief.deepest <= 0.0 {
        return traced;
    }
    let seen = host_in_ground(traced, -to_eye);
    let way = normalize(vec3f(seen.xy, min(seen.z, -HOST_GRAZING)));
    traced.hit = terrane_trace(relief, DisplacedRay(vec3f(0.0), way));
    traced.point = way * traced.hit.distance;
    traced.moved = -to_eye * traced.hit.distance;
    let along = tangent * traced.point.x + bitangent * traced.point.y;
    traced.frame.position.local += along;
    traced.frame.terrain_uv.uv += along.xz / extent;
    traced.frame.height += along.y;
    traced.frame.distance += traced.hit.distance;
    return traced;
}

/// 0..1, another for each pixel. Source: Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare", 2014
/// (interleaved gradient noise).
fn host_dither(pixel: vec2f) -> f32 {
    return fract(52.9829189 * fract(dot(floor(pixel), vec2f(0.06711056, 0.00583715))));
}

/// Share of the sun that the relief leaves, where the surface faces it.
fn host_relief_sun(traced: HostTraced, normal: vec3f) -> f32 {
    let light = host_in_ground(traced, host_view.sun);
    if traced.relief.deepest <= 0.0 || dot(normal, host_view.sun) <= 0.0 || light.z <= 0.0 {
        return 1.0;
    }
    return terrane_sunlit(traced.relief, DisplacedRay(traced.point, light), host_view.sun_radius);
}

/// Share of the sky that the relief leaves.
fn host_relief_sky(traced: HostTraced, normal: vec3f, pixel: vec2f) -> f32 {
    if traced.relief.deepest <= 0.0 {
        return 1.0;
    }
    return terrane_open(traced.relief, traced.point, normal, host_dither(pixel) * 6.28318531);
}
