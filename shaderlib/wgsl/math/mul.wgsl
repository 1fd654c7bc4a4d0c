//! The product of two numbers, vectors or colours, component by component.
//! Source: W3C, "WebGPU Shading Language", section 8.7 (arithmetic expressions).

/// mul_f32(1.5, 0.5) == 0.75 +- 1e-6
/// -> The product. -1000000000000..1000000000000
fn mul_f32(
    /// What to multiply. -1000000..1000000
    a: f32,
    /// How often. -1000000..1000000 = 1.0
    b: f32,
) -> f32 {
    return a * b;
}

/// mul_vec2(vec2f(1.5, -2.0), vec2f(0.5, 4.0)) == vec2f(0.75, -8.0) +- 1e-6
/// -> The product. -1000000000000..1000000000000
fn mul_vec2(
    /// What to multiply. -1000000..1000000
    a: vec2f,
    /// How often. -1000000..1000000 = (1.0, 1.0)
    b: vec2f,
) -> vec2f {
    return a * b;
}

/// mul_vec3(vec3f(1.5, -2.0, 0.25), vec3f(0.5, 4.0, -1.0)) == vec3f(0.75, -8.0, -0.25) +- 1e-6
/// -> The product. -1000000000000..1000000000000
fn mul_vec3(
    /// What to multiply. -1000000..1000000
    a: vec3f,
    /// How often. -1000000..1000000 = (1.0, 1.0, 1.0)
    b: vec3f,
) -> vec3f {
    return a * b;
}

/// mul_vec4(vec4f(1.5, -2.0, 0.25, 8.0), vec4f(0.5, 4.0, -1.0, 2.0)) == vec4f(0.75, -8.0, -0.25, 16.0) +- 1e-6
/// -> The product. -1000000000000..1000000000000
fn mul_vec4(
    /// What to multiply. -1000000..1000000
    a: vec4f,
    /// How often. -1000000..1000000 = (1.0, 1.0, 1.0, 1.0)
    b: vec4f,
) -> vec4f {
    return a * b;
}
