//! The value with the other sign.
//! Source: W3C, "WebGPU Shading Language", section 8.7 (arithmetic expressions).

/// negate_f32(1.5) == -1.5 +- 1e-6
/// -> The negative. -1000000..1000000
fn negate_f32(
    /// The value. -1000000..1000000
    x: f32,
) -> f32 {
    return -x;
}

/// negate_vec2(vec2f(1.5, -2.0)) == vec2f(-1.5, 2.0) +- 1e-6
/// -> The negative. -1000000..1000000
fn negate_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
) -> vec2f {
    return -x;
}

/// negate_vec3(vec3f(1.5, -2.0, 0.25)) == vec3f(-1.5, 2.0, -0.25) +- 1e-6
/// -> The negative. -1000000..1000000
fn negate_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
) -> vec3f {
    return -x;
}

/// negate_vec4(vec4f(1.5, -2.0, 0.25, 8.0)) == vec4f(-1.5, 2.0, -0.25, -8.0) +- 1e-6
/// -> The negative. -1000000..1000000
fn negate_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
) -> vec4f {
    return -x;
}
