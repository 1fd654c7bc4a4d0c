//! The value times itself.
//! Source: W3C, "WebGPU Shading Language", section 8.7 (arithmetic expressions).

/// squared_f32(1.5) == 2.25 +- 1e-6
/// -> The square. 0..1000000000000
fn squared_f32(
    /// The value. -1000000..1000000
    x: f32,
) -> f32 {
    return x * x;
}

/// squared_vec2(vec2f(1.5, -2.0)) == vec2f(2.25, 4.0) +- 1e-6
/// -> The square. 0..1000000000000
fn squared_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
) -> vec2f {
    return x * x;
}

/// squared_vec3(vec3f(1.5, -2.0, 0.25)) == vec3f(2.25, 4.0, 0.0625) +- 1e-6
/// -> The square. 0..1000000000000
fn squared_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
) -> vec3f {
    return x * x;
}

/// squared_vec4(vec4f(1.5, -2.0, 0.25, 8.0)) == vec4f(2.25, 4.0, 0.0625, 64.0) +- 1e-6
/// -> The square. 0..1000000000000
fn squared_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
) -> vec4f {
    return x * x;
}
