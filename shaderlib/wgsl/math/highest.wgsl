//! The higher of two values, component by component.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): max.

/// highest_f32(1.5, 0.5) == 1.5 +- 1e-6
/// -> The higher one. -1000000..1000000
fn highest_f32(
    /// One value. -1000000..1000000
    a: f32,
    /// The other one. -1000000..1000000
    b: f32,
) -> f32 {
    return max(a, b);
}

/// highest_vec2(vec2f(1.5, -2.0), vec2f(0.5, 4.0)) == vec2f(1.5, 4.0) +- 1e-6
/// -> The higher one. -1000000..1000000
fn highest_vec2(
    /// One value. -1000000..1000000
    a: vec2f,
    /// The other one. -1000000..1000000
    b: vec2f,
) -> vec2f {
    return max(a, b);
}

/// highest_vec3(vec3f(1.5, -2.0, 0.25), vec3f(0.5, 4.0, -1.0)) == vec3f(1.5, 4.0, 0.25) +- 1e-6
/// -> The higher one. -1000000..1000000
fn highest_vec3(
    /// One value. -1000000..1000000
    a: vec3f,
    /// The other one. -1000000..1000000
    b: vec3f,
) -> vec3f {
    return max(a, b);
}

/// highest_vec4(vec4f(1.5, -2.0, 0.25, 8.0), vec4f(0.5, 4.0, -1.0, 2.0)) == vec4f(1.5, 4.0, 0.25, 8.0) +- 1e-6
/// -> The higher one. -1000000..1000000
fn highest_vec4(
    /// One value. -1000000..1000000
    a: vec4f,
    /// The other one. -1000000..1000000
    b: vec4f,
) -> vec4f {
    return max(a, b);
}
