//! The distance between two points.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): distance.

/// span_between_vec2(vec2f(4.0, -2.0), vec2f(1.0, 2.0)) == 5.0 +- 1e-4
/// -> The distance. 0..4000004
fn span_between_vec2(
    /// One point. -1000000..1000000
    a: vec2f,
    /// The other one. -1000000..1000000
    b: vec2f,
) -> f32 {
    return distance(a, b);
}

/// span_between_vec3(vec3f(4.0, -2.0, 12.0), vec3f(1.0, 2.0, 0.0)) == 13.0 +- 1e-4
/// -> The distance. 0..4000004
fn span_between_vec3(
    /// One point. -1000000..1000000
    a: vec3f,
    /// The other one. -1000000..1000000
    b: vec3f,
) -> f32 {
    return distance(a, b);
}

/// span_between_vec4(vec4f(4.0, -2.0, 12.0, 84.0), vec4f(1.0, 2.0, 0.0, 0.0)) == 85.0 +- 1e-4
/// -> The distance. 0..4000004
fn span_between_vec4(
    /// One point. -1000000..1000000
    a: vec4f,
    /// The other one. -1000000..1000000
    b: vec4f,
) -> f32 {
    return distance(a, b);
}
