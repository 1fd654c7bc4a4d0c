//! The next whole number below.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): floor.

/// whole_f32(1.5) == 1.0 +- 1e-6
/// -> A whole number. -1000000..1000000
fn whole_f32(
    /// The value. -1000000..1000000
    x: f32,
) -> f32 {
    return floor(x);
}

/// whole_vec2(vec2f(1.5, -2.25)) == vec2f(1.0, -3.0) +- 1e-6
/// -> A whole number. -1000000..1000000
fn whole_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
) -> vec2f {
    return floor(x);
}

/// whole_vec3(vec3f(1.5, -2.25, 0.0)) == vec3f(1.0, -3.0, 0.0) +- 1e-6
/// -> A whole number. -1000000..1000000
fn whole_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
) -> vec3f {
    return floor(x);
}

/// whole_vec4(vec4f(1.5, -2.25, 0.0, 7.0)) == vec4f(1.0, -3.0, 0.0, 7.0) +- 1e-6
/// -> A whole number. -1000000..1000000
fn whole_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
) -> vec4f {
    return floor(x);
}
