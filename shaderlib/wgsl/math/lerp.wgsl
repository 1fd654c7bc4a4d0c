//! From one value to another: exactly `a` at 0 and exactly `b` at 1.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (mix).

/// lerp_f32(1.5, 0.5, 0.25) == 1.25 +- 1e-6
/// -> Between the two. -1000000..1000000
fn lerp_f32(
    /// What 0 gives. -1000000..1000000
    a: f32,
    /// What 1 gives. -1000000..1000000
    b: f32,
    /// How far on the way. 0..1 = 0.5
    t: f32,
) -> f32 {
    return clamp(mix(a, b, t), min(a, b), max(a, b));
}

/// lerp_vec2(vec2f(1.5, -2.0), vec2f(0.5, 4.0), 0.25) == vec2f(1.25, -0.5) +- 1e-6
/// -> Between the two. -1000000..1000000
fn lerp_vec2(
    /// What 0 gives. -1000000..1000000
    a: vec2f,
    /// What 1 gives. -1000000..1000000
    b: vec2f,
    /// How far on the way. 0..1 = 0.5
    t: f32,
) -> vec2f {
    return clamp(mix(a, b, t), min(a, b), max(a, b));
}

/// lerp_vec3(vec3f(1.5, -2.0, 0.25), vec3f(0.5, 4.0, -1.0), 0.25) == vec3f(1.25, -0.5, -0.0625) +- 1e-6
/// -> Between the two. -1000000..1000000
fn lerp_vec3(
    /// What 0 gives. -1000000..1000000
    a: vec3f,
    /// What 1 gives. -1000000..1000000
    b: vec3f,
    /// How far on the way. 0..1 = 0.5
    t: f32,
) -> vec3f {
    return clamp(mix(a, b, t), min(a, b), max(a, b));
}

/// lerp_vec4(vec4f(1.5, -2.0, 0.25, 8.0), vec4f(0.5, 4.0, -1.0, 2.0), 0.25) == vec4f(1.25, -0.5, -0.0625, 6.5) +- 1e-6
/// -> Between the two. -1000000..1000000
fn lerp_vec4(
    /// What 0 gives. -1000000..1000000
    a: vec4f,
    /// What 1 gives. -1000000..1000000
    b: vec4f,
    /// How far on the way. 0..1 = 0.5
    t: f32,
) -> vec4f {
    return clamp(mix(a, b, t), min(a, b), max(a, b));
}
