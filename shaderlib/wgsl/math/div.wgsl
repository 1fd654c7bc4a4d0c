//! A quotient that is never infinite: divisors nearer to 0 than 0.000001 count as that, with their sign.
//! Source: W3C, "WebGPU Shading Language", section 8.7 (arithmetic expressions); division is only defined away from 0.

/// div_f32(1.5, 0.5) == 3.0 +- 1e-6
/// -> The quotient. -1000000000000..1000000000000
fn div_f32(
    /// What to divide. -1000000..1000000
    a: f32,
    /// By what. -1000000..1000000 = 1.0
    b: f32,
) -> f32 {
    let away = select(max(b, 1e-6), min(b, -1e-6), b < 0.0);
    return clamp(a / away, -1e12, 1e12);
}

/// div_vec2(vec2f(1.5, -2.0), vec2f(0.5, 4.0)) == vec2f(3.0, -0.5) +- 1e-6
/// -> The quotient. -1000000000000..1000000000000
fn div_vec2(
    /// What to divide. -1000000..1000000
    a: vec2f,
    /// By what. -1000000..1000000 = (1.0, 1.0)
    b: vec2f,
) -> vec2f {
    let away = select(max(b, vec2f(1e-6)), min(b, vec2f(-1e-6)), b < vec2f(0.0));
    return clamp(a / away, vec2f(-1e12), vec2f(1e12));
}

/// div_vec3(vec3f(1.5, -2.0, 0.25), vec3f(0.5, 4.0, -1.0)) == vec3f(3.0, -0.5, -0.25) +- 1e-6
/// -> The quotient. -1000000000000..1000000000000
fn div_vec3(
    /// What to divide. -1000000..1000000
    a: vec3f,
    /// By what. -1000000..1000000 = (1.0, 1.0, 1.0)
    b: vec3f,
) -> vec3f {
    let away = select(max(b, vec3f(1e-6)), min(b, vec3f(-1e-6)), b < vec3f(0.0));
    return clamp(a / away, vec3f(-1e12), vec3f(1e12));
}

/// div_vec4(vec4f(1.5, -2.0, 0.25, 8.0), vec4f(0.5, 4.0, -1.0, 2.0)) == vec4f(3.0, -0.5, -0.25, 4.0) +- 1e-6
/// -> The quotient. -1000000000000..1000000000000
fn div_vec4(
    /// What to divide. -1000000..1000000
    a: vec4f,
    /// By what. -1000000..1000000 = (1.0, 1.0, 1.0, 1.0)
    b: vec4f,
) -> vec4f {
    let away = select(max(b, vec4f(1e-6)), min(b, vec4f(-1e-6)), b < vec4f(0.0));
    return clamp(a / away, vec4f(-1e12), vec4f(1e12));
}
