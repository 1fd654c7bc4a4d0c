//! What is missing to 1: inverts masks and colours.
//! Source: W3C, "WebGPU Shading Language", section 8.7 (arithmetic expressions).

/// one_minus_f32(1.5) == -0.5 +- 1e-6
/// -> The complement. -1000000..1000001
fn one_minus_f32(
    /// The value. -1000000..1000000
    x: f32,
) -> f32 {
    return 1.0 - x;
}

/// one_minus_vec2(vec2f(1.5, -2.0)) == vec2f(-0.5, 3.0) +- 1e-6
/// -> The complement. -1000000..1000001
fn one_minus_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
) -> vec2f {
    return 1.0 - x;
}

/// one_minus_vec3(vec3f(1.5, -2.0, 0.25)) == vec3f(-0.5, 3.0, 0.75) +- 1e-6
/// -> The complement. -1000000..1000001
fn one_minus_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
) -> vec3f {
    return 1.0 - x;
}

/// one_minus_vec4(vec4f(1.5, -2.0, 0.25, 8.0)) == vec4f(-0.5, 3.0, 0.75, -7.0) +- 1e-6
/// -> The complement. -1000000..1000001
fn one_minus_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
) -> vec4f {
    return 1.0 - x;
}
