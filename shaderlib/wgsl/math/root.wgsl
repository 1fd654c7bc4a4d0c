//! The square root; 0 for negative values.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): sqrt, whose domain excludes negative values.

/// root_f32(2.25) == 1.5 +- 1e-5
/// -> The root. 0..1000.01
fn root_f32(
    /// The value. -1000000..1000000
    x: f32,
) -> f32 {
    return select(sqrt(max(x, 1e-30)), 0.0, x <= 0.0);
}

/// root_vec2(vec2f(2.25, -4.0)) == vec2f(1.5, 0.0) +- 1e-5
/// -> The root. 0..1000.01
fn root_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
) -> vec2f {
    return select(sqrt(max(x, vec2f(1e-30))), vec2f(0.0), x <= vec2f(0.0));
}

/// root_vec3(vec3f(2.25, -4.0, 0.0)) == vec3f(1.5, 0.0, 0.0) +- 1e-5
/// -> The root. 0..1000.01
fn root_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
) -> vec3f {
    return select(sqrt(max(x, vec3f(1e-30))), vec3f(0.0), x <= vec3f(0.0));
}

/// root_vec4(vec4f(2.25, -4.0, 0.0, 16.0)) == vec4f(1.5, 0.0, 0.0, 4.0) +- 1e-5
/// -> The root. 0..1000.01
fn root_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
) -> vec4f {
    return select(sqrt(max(x, vec4f(1e-30))), vec4f(0.0), x <= vec4f(0.0));
}
