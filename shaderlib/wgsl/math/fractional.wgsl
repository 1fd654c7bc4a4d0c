//! What a value has beyond the next whole number below: a saw-tooth.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): fract, which may round to 1.

/// fractional_f32(1.5) == 0.5 +- 1e-6
/// -> From 0 up to but not including 1. 0..1
fn fractional_f32(
    /// The value. -1000000..1000000
    x: f32,
) -> f32 {
    return min(x - floor(x), LATTICE_BELOW_ONE);
}

/// fractional_vec2(vec2f(1.5, -2.25)) == vec2f(0.5, 0.75) +- 1e-6
/// -> From 0 up to but not including 1. 0..1
fn fractional_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
) -> vec2f {
    return min(x - floor(x), vec2f(LATTICE_BELOW_ONE));
}

/// fractional_vec3(vec3f(1.5, -2.25, 0.0)) == vec3f(0.5, 0.75, 0.0) +- 1e-6
/// -> From 0 up to but not including 1. 0..1
fn fractional_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
) -> vec3f {
    return min(x - floor(x), vec3f(LATTICE_BELOW_ONE));
}

/// fractional_vec4(vec4f(1.5, -2.25, 0.0, 7.0)) == vec4f(0.5, 0.75, 0.0, 0.0) +- 1e-6
/// -> From 0 up to but not including 1. 0..1
fn fractional_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
) -> vec4f {
    return min(x - floor(x), vec4f(LATTICE_BELOW_ONE));
}
