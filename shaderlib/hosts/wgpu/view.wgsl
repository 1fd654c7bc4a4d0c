//! What the renderer gives to every shader of a picture: group 0.
//!
//! Lights and tables are multiplied by the exposure and the white balance before they come here.

struct HostView {
    /// Metres relative to the eye to clip space; depth 1 near, 0 at infinity.
    clip: mat4x4f,
    /// A ray through the picture is forward + x · right + y · up, x and y in −1..1.
    right: vec3f,
    /// Metres above height 0.
    eye_height: f32,
    up: vec3f,
    /// Metres to the far side of `host_aerial`.
    aerial_reach: f32,
    forward: vec3f,
    /// Tangent of the sun's angular radius.
    sun_radius: f32,
    /// Unit vector to the sun.
    sun: vec3f,
    /// Metres from height 0 to the terrain's lowest place.
    low: f32,
    /// Irradiance of the sun, there, on a surface that faces it.
    sun_low: vec3f,
    /// Metres between the terrain's lowest and highest place.
    height_range: f32,
    /// Irradiance of the sun at the highest place.
    sun_high: vec3f,
    /// 1/m: how fast the molecules' density falls with height.
    rayleigh_fall: f32,
    /// Radiance of the middle of the sun's disc, seen from the eye.
    sun_disc: vec3f,
    /// 1/m: how fast the haze's density falls with height.
    haze_fall: f32,
    /// 1/m at height 0, by molecules.
    rayleigh: vec3f,
    /// 1/m at height 0, by haze: scattering and absorption.
    haze: vec3f,
    /// Spherical harmonics of the upper sky's irradiance.
    sky: array<vec4f, 9>,
    /// The texel whose centre is nearest to the eye.
    eye_texel: vec2i,
    /// Metres on x and z from that centre to the eye.
    eye_offset: vec2f,
    /// Metres between texels on x and z.
    spacing: vec2f,
    /// Pixels of the picture, before it is resolved.
    pixels: vec2f,
}

@group(0) @binding(0) var<uniform> host_view: HostView;
/// Radiance by azimuth from the sun and elevation.
@group(0) @binding(1) var host_sky: texture_2d<f32>;
/// Light scattered by the air before a place, by pixel and distance.
@group(0) @binding(2) var host_aerial: texture_3d<f32>;
/// Linear, clamped.
@group(0) @binding(3) var host_sampler: sampler;

/// Radiance of the sky in a direction, without the sun.
fn host_sky_radiance(direction: vec3f) -> vec3f {
    let size = vec2f(textureDimensions(host_sky));
    let flat = direction.xz * inverseSqrt(max(dot(direction.xz, direction.xz), 1e-12));
    let sun = host_view.sun.xz * inverseSqrt(max(dot(host_view.sun.xz, host_view.sun.xz), 1e-12));
    let azimuth = acos(clamp(dot(flat, sun), -1.0, 1.0));
    let elevation = asin(clamp(direction.y, -1.0, 1.0));
    let v = sign(elevation) * sqrt(abs(elevation) * 0.636619772);
    let uv = vec2f(sqrt(azimuth * 0.318309886), v * 0.5 + 0.5);
    return textureSampleLevel(host_sky, host_sampler, (uv * (size - 1.0) + 0.5) / size, 0.0).rgb;
}

/// Optical depth of `distance` metres of air whose density falls exponentially, from the eye to a height.
fn host_air_depth(height: f32, distance: f32, fall: f32) -> f32 {
    let drop = (height - host_view.eye_height) * fall;
    // (1 − exp(−x)) / x, by its series where the quotient would lose all digits.
    let mean = select((1.0 - exp(-drop)) / drop, 1.0 - drop * (0.5 - drop / 6.0), abs(drop) < 0.01);
    return exp(-max(host_view.eye_height, 0.0) * fall) * mean * distance;
}

/// What remains of a place's light on its way to the eye, and what the air adds. `picture`: pixel over `pixels`.
fn host_through_air(radiance: vec3f, picture: vec2f, height: f32, distance: f32) -> vec3f {
    let depth = host_view.rayleigh * host_air_depth(height, distance, host_view.rayleigh_fall)
        + host_view.haze * host_air_depth(height, distance, host_view.haze_fall);
    let size = vec3f(textureDimensions(host_aerial));
    let along = sqrt(min(distance / host_view.aerial_reach, 1.0)) * size.z;
    let uv = (picture * (size.xy - 1.0) + 0.5) / size.xy;
    let added = textureSampleLevel(host_aerial, host_sampler, vec3f(uv, (along - 0.5) / size.z), 0.0).rgb;
    // Before the far side of the first cells the light grows with the distance, that is with the square of `along`.
    return radiance * exp(-depth) + added * min(along * along, 1.0);
}
