//! Holds a value between 0 and 1.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): saturate.

/// clamp01_f32(1.5) == 1.0 +- 1e-6
/// -> The held value. 0..1
fn clamp01_f32(
    /// The value. -1000000..1000000
    x: f32,
) -> f32 {
    return saturate(x);
}

/// clamp01_vec2(vec2f(1.5, -2.0)) == vec2f(1.0, 0.0) +- 1e-6
/// -> The held value. 0..1
fn clamp01_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
) -> vec2f {
    return saturate(x);
}

/// clamp01_vec3(vec3f(1.5, -2.0, 0.25)) == vec3f(1.0, 0.0, 0.25) +- 1e-6
/// -> The held value. 0..1
fn clamp01_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
) -> vec3f {
    return saturate(x);
}

/// clamp01_vec4(vec4f(1.5, -2.0, 0.25, 8.0)) == vec4f(1.0, 0.0, 0.25, 1.0) +- 1e-6
/// -> The held value. 0..1
fn clamp01_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
) -> vec4f {
    return saturate(x);
}
