//! The terrain under a pixel: shape, and the light that the shape lets in.

/// Metres; with mips.
@group(0) @binding(4) var host_height: texture_2d<f32>;
/// Tangent of the horizon under the sun; with mips.
@group(0) @binding(5) var host_horizon: texture_2d<f32>;
/// Layer 0, xyz: (1/π) ∫ ω dω over the visible sky; w: share of the sun's irradiance on the ground around.
/// Layer 1: tangents of the horizon under the sun where the terrain is mirrored on neither axis, x, z, both.
@group(0) @binding(6) var host_light: texture_2d_array<f32>;

/// Slope and bend of the height map: metres per metre, and 1/m.
struct HostShape { gradient: vec2f, second: vec2f, mixed: f32 }

/// Weights of the uniform cubic B-spline for four texels.
fn host_spline(t: f32) -> vec4f {
    let s = 1.0 - t;
    return vec4f(s * s * s, 4.0 - 3.0 * t * t * (2.0 - t), 4.0 - 3.0 * s * s * (2.0 - s), t * t * t) / 6.0;
}

/// Weights of its first derivative.
fn host_spline_slope(t: f32) -> vec4f {
    let s = 1.0 - t;
    return vec4f(-s * s, t * (3.0 * t - 4.0), -s * (3.0 * s - 4.0), t * t) * 0.5;
}

/// Weights of its second derivative.
fn host_spline_bend(t: f32) -> vec4f {
    return vec4f(1.0 - t, 3.0 * t - 2.0, 1.0 - 3.0 * t, t);
}

/// The B-spline through 4 × 4 texels of a mip: smooth where the bilinear surface has edges. `texel`: in units of level
/// 0, whole numbers at texel centres; `part` is added to it, so that both stay exact far from the terrain's corner.
fn host_shape(texel: vec2i, part: vec2f, level: i32) -> HostShape {
    let scale = f32(1i << u32(level));
    let last = vec2i(textureDimensions(host_height, level)) - 1i;
    // A mip's centres lie between those of level 0.
    let base = texel >> vec2u(u32(level));
    let place = (vec2f(texel - (base << vec2u(u32(level)))) + part + 0.5) / scale - 0.5;
    let whole = floor(place);
    let t = place - whole;
    let corner = base + vec2i(whole) - 1i;
    let weight_x = host_spline(t.x);
    let weight_z = host_spline(t.y);
    let slope_x = host_spline_slope(t.x);
    let slope_z = host_spline_slope(t.y);
    let bend_x = host_spline_bend(t.x);
    let bend_z = host_spline_bend(t.y);
    var gradient = vec2f(0.0);
    var second = vec2f(0.0);
    var mixed = 0.0;
    for (var j = 0i; j < 4i; j++) {
        let row = clamp(corner.y + j, 0i, last.y);
        let columns = clamp(vec4i(corner.x) + vec4i(0i, 1i, 2i, 3i), vec4i(0i), vec4i(last.x));
        let heights = vec4f(
            textureLoad(host_height, vec2i(columns.x, row), level).r,
            textureLoad(host_height, vec2i(columns.y, row), level).r,
            textureLoad(host_height, vec2i(columns.z, row), level).r,
            textureLoad(host_height, vec2i(columns.w, row), level).r,
        );
        let value = dot(heights, weight_x);
        let across = dot(heights, slope_x);
        gradient += vec2f(across * weight_z[j], value * slope_z[j]);
        second += vec2f(dot(heights, bend_x) * weight_z[j], value * bend_z[j]);
        mixed += across * slope_z[j];
    }
    let metres = host_view.spacing * scale;
    return HostShape(gradient / metres, second / (metres * metres), mixed / (metres.x * metres.y));
}

/// The shape at the size of a pixel: `level` is the log2 of its footprint in texels.
fn host_shape_filtered(texel: vec2i, part: vec2f, level: f32) -> HostShape {
    let lower = i32(level);
    let shape = host_shape(texel, part, lower);
    let blend = level - f32(lower);
    if blend == 0.0 {
        return shape;
    }
    let other = host_shape(texel, part, lower + 1i);
    return HostShape(
        mix(shape.gradient, other.gradient, blend),
        mix(shape.second, other.second, blend),
        mix(shape.mixed, other.mixed, blend),
    );
}

/// The shape of a mirror image.
fn host_shape_mirrored(shape: HostShape, mirror: vec2f) -> HostShape {
    return HostShape(shape.gradient * mirror, shape.second, shape.mixed * mirror.x * mirror.y);
}

/// Tangent of the horizon under the sun: fine on the terrain itself, coarse on its images.
fn host_horizon_at(uv: vec2f, level: f32, mirror: vec2f, itself: bool) -> f32 {
    if itself {
        return textureSampleLevel(host_horizon, host_sampler, uv, level).r;
    }
    let image = textureSampleLevel(host_light, host_sampler, uv, 1i, 0.0);
    let rows = select(image.zw, image.xy, mirror.y > 0.0);
    return select(rows.y, rows.x, mirror.x > 0.0);
}

fn host_normal(shape: HostShape) -> vec3f {
    return normalize(vec3f(-shape.gradient.x, 1.0, -shape.gradient.y));
}

/// Mean curvature of the surface, positive on ridges.
fn host_curvature(shape: HostShape) -> f32 {
    let g = shape.gradient;
    let bend = (1.0 + g.y * g.y) * shape.second.x + (1.0 + g.x * g.x) * shape.second.y - 2.0 * g.x * g.y * shape.mixed;
    let steep = 1.0 + dot(g, g);
    return -0.5 * bend / (steep * sqrt(steep));
}
