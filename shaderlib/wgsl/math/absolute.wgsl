//! The value without its sign.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): abs.

/// absolute_f32(1.5) == 1.5 +- 1e-6
/// -> The size. 0..1000000
fn absolute_f32(
    /// The value. -1000000..1000000
    x: f32,
) -> f32 {
    return abs(x);
}

/// absolute_vec2(vec2f(1.5, -2.0)) == vec2f(1.5, 2.0) +- 1e-6
/// -> The size. 0..1000000
fn absolute_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
) -> vec2f {
    return abs(x);
}

/// absolute_vec3(vec3f(1.5, -2.0, 0.25)) == vec3f(1.5, 2.0, 0.25) +- 1e-6
/// -> The size. 0..1000000
fn absolute_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
) -> vec3f {
    return abs(x);
}

/// absolute_vec4(vec4f(1.5, -2.0, 0.25, 8.0)) == vec4f(1.5, 2.0, 0.25, 8.0) +- 1e-6
/// -> The size. 0..1000000
fn absolute_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
) -> vec4f {
    return abs(x);
}
