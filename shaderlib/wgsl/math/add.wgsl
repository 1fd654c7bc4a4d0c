//! The sum of two numbers, vectors or colours.
//! Source: W3C, "WebGPU Shading Language", section 8.7 (arithmetic expressions).

/// add_f32(1.5, 0.5) == 2.0 +- 1e-6
/// -> The sum. -2000000..2000000
fn add_f32(
    /// What to add to. -1000000..1000000
    a: f32,
    /// What to add. -1000000..1000000
    b: f32,
) -> f32 {
    return a + b;
}

/// add_vec2(vec2f(1.5, -2.0), vec2f(0.5, 4.0)) == vec2f(2.0, 2.0) +- 1e-6
/// -> The sum. -2000000..2000000
fn add_vec2(
    /// What to add to. -1000000..1000000
    a: vec2f,
    /// What to add. -1000000..1000000
    b: vec2f,
) -> vec2f {
    return a + b;
}

/// add_vec3(vec3f(1.5, -2.0, 0.25), vec3f(0.5, 4.0, -1.0)) == vec3f(2.0, 2.0, -0.75) +- 1e-6
/// -> The sum. -2000000..2000000
fn add_vec3(
    /// What to add to. -1000000..1000000
    a: vec3f,
    /// What to add. -1000000..1000000
    b: vec3f,
) -> vec3f {
    return a + b;
}

/// add_vec4(vec4f(1.5, -2.0, 0.25, 8.0), vec4f(0.5, 4.0, -1.0, 2.0)) == vec4f(2.0, 2.0, -0.75, 10.0) +- 1e-6
/// -> The sum. -2000000..2000000
fn add_vec4(
    /// What to add to. -1000000..1000000
    a: vec4f,
    /// What to add. -1000000..1000000
    b: vec4f,
) -> vec4f {
    return a + b;
}
