//! Holds a value between two others; either of them may be the lower one.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): clamp, which is undefined when its limits are reversed.

/// limit_f32(1.5, 0.0, 1.0) == 1.0 +- 1e-6
/// -> The held value. -1000000..1000000
fn limit_f32(
    /// The value. -1000000..1000000
    x: f32,
    /// One limit. -1000000..1000000 = 0.0
    low: f32,
    /// The other limit. -1000000..1000000 = 1.0
    high: f32,
) -> f32 {
    return clamp(x, min(low, high), max(low, high));
}

/// limit_vec2(vec2f(1.5, -2.0), vec2f(0.0, 0.0), vec2f(1.0, 1.0)) == vec2f(1.0, 0.0) +- 1e-6
/// -> The held value. -1000000..1000000
fn limit_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
    /// One limit. -1000000..1000000 = (0.0, 0.0)
    low: vec2f,
    /// The other limit. -1000000..1000000 = (1.0, 1.0)
    high: vec2f,
) -> vec2f {
    return clamp(x, min(low, high), max(low, high));
}

/// limit_vec3(vec3f(1.5, -2.0, 0.25), vec3f(0.0, 0.0, 1.0), vec3f(1.0, 1.0, 0.0)) == vec3f(1.0, 0.0, 0.25) +- 1e-6
/// -> The held value. -1000000..1000000
fn limit_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
    /// One limit. -1000000..1000000 = (0.0, 0.0, 0.0)
    low: vec3f,
    /// The other limit. -1000000..1000000 = (1.0, 1.0, 1.0)
    high: vec3f,
) -> vec3f {
    return clamp(x, min(low, high), max(low, high));
}

/// limit_vec4(vec4f(1.5, -2.0, 0.25, 8.0), vec4f(0.0, 0.0, 1.0, 0.0), vec4f(1.0, 1.0, 0.0, 5.0)) == vec4f(1.0, 0.0, 0.25, 5.0) +- 1e-6
/// -> The held value. -1000000..1000000
fn limit_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
    /// One limit. -1000000..1000000 = (0.0, 0.0, 0.0, 0.0)
    low: vec4f,
    /// The other limit. -1000000..1000000 = (1.0, 1.0, 1.0, 1.0)
    high: vec4f,
) -> vec4f {
    return clamp(x, min(low, high), max(low, high));
}
