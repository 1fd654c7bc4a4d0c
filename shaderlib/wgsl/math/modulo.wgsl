//! The remainder of a division, never negative: repeats a ramp.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): floor; Knuth, "The Art of Computer Programming", volume 1, section 1.2.4 (mod).

/// modulo_f32(5.5, 2.0) == 1.5 +- 1e-5
/// -> From 0 to the period. 0..1000000
fn modulo_f32(
    /// The value. -1000000..1000000
    x: f32,
    /// After which it starts again. 0.001..1000000 = 1.0
    period: f32,
) -> f32 {
    let span = max(period, 0.001);
    return clamp(x - span * floor(x / span), 0.0, span);
}

/// modulo_vec2(vec2f(5.5, -1.0), vec2f(2.0, 4.0)) == vec2f(1.5, 3.0) +- 1e-5
/// -> From 0 to the period. 0..1000000
fn modulo_vec2(
    /// The value. -1000000..1000000
    x: vec2f,
    /// After which it starts again. 0.001..1000000 = (1.0, 1.0)
    period: vec2f,
) -> vec2f {
    let span = max(period, vec2f(0.001));
    return clamp(x - span * floor(x / span), vec2f(0.0), span);
}

/// modulo_vec3(vec3f(5.5, -1.0, 0.25), vec3f(2.0, 4.0, 1.0)) == vec3f(1.5, 3.0, 0.25) +- 1e-5
/// -> From 0 to the period. 0..1000000
fn modulo_vec3(
    /// The value. -1000000..1000000
    x: vec3f,
    /// After which it starts again. 0.001..1000000 = (1.0, 1.0, 1.0)
    period: vec3f,
) -> vec3f {
    let span = max(period, vec3f(0.001));
    return clamp(x - span * floor(x / span), vec3f(0.0), span);
}

/// modulo_vec4(vec4f(5.5, -1.0, 0.25, 8.0), vec4f(2.0, 4.0, 1.0, 8.0)) == vec4f(1.5, 3.0, 0.25, 0.0) +- 1e-5
/// -> From 0 to the period. 0..1000000
fn modulo_vec4(
    /// The value. -1000000..1000000
    x: vec4f,
    /// After which it starts again. 0.001..1000000 = (1.0, 1.0, 1.0, 1.0)
    period: vec4f,
) -> vec4f {
    let span = max(period, vec4f(0.001));
    return clamp(x - span * floor(x / span), vec4f(0.0), span);
}
