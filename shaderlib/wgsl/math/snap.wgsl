//! The nearest multiple of a step.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): round.

/// snap_f32(1.6, 1.0) == 2.0 +- 1e-6
/// -> A multiple of the step. -2000000..2000000
fn snap_f32(
    /// The value. -1000000..1000000
    x: f32,
    /// The step. 0.001..1000000 = 1.0
    size: f32,
) -> f32 {
    return round(x / max(size, 0.001)) * size;
}

/// snap_vec2(vec2f(1.6, -2.3), vec2f(1.0, 0.5)) == vec2f(2.0, -2.5) +- 1e-6
/// -> A multiple of the step. -2000000..2000000
fn snap_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
    /// The step. 0.001..1000000 = (1.0, 1.0)
    size: vec2f,
) -> vec2f {
    return round(x / max(size, vec2f(0.001))) * size;
}

/// snap_vec3(vec3f(1.6, -2.3, 0.25), vec3f(1.0, 0.5, 1.0)) == vec3f(2.0, -2.5, 0.0) +- 1e-6
/// -> A multiple of the step. -2000000..2000000
fn snap_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
    /// The step. 0.001..1000000 = (1.0, 1.0, 1.0)
    size: vec3f,
) -> vec3f {
    return round(x / max(size, vec3f(0.001))) * size;
}

/// snap_vec4(vec4f(1.6, -2.3, 0.25, 7.0), vec4f(1.0, 0.5, 1.0, 4.0)) == vec4f(2.0, -2.5, 0.0, 8.0) +- 1e-6
/// -> A multiple of the step. -2000000..2000000
fn snap_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
    /// The step. 0.001..1000000 = (1.0, 1.0, 1.0, 1.0)
    size: vec4f,
) -> vec4f {
    return round(x / max(size, vec4f(0.001))) * size;
}
