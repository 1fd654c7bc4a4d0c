//! The length of a vector.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): length.

/// magnitude_vec2(vec2f(3.0, -4.0)) == 5.0 +- 1e-4
/// -> The length. 0..2000002
fn magnitude_vec2(
    /// Of any direction. -1000000..1000000
    v: vec2f,
) -> f32 {
    return length(v);
}

/// magnitude_vec3(vec3f(3.0, -4.0, 12.0)) == 13.0 +- 1e-4
/// -> The length. 0..2000002
fn magnitude_vec3(
    /// Of any direction. -1000000..1000000
    v: vec3f,
) -> f32 {
    return length(v);
}

/// magnitude_vec4(vec4f(3.0, -4.0, 12.0, 84.0)) == 85.0 +- 1e-4
/// -> The length. 0..2000002
fn magnitude_vec4(
    /// Of any direction. -1000000..1000000
    v: vec4f,
) -> f32 {
    return length(v);
}
