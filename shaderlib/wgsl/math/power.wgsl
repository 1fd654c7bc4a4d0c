//! A power that keeps the sign of its base, so that it is defined everywhere; a root is a power below 1.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): pow, whose domain excludes negative bases.

/// power_f32(4.0, 0.5) == 2.0 +- 1e-4
/// -> The power. -1000000000000000000000000..1000000000000000000000000
fn power_f32(
    /// The base. -1000..1000
    x: f32,
    /// The exponent. 0.01..8 = 2.0
    exponent: f32,
) -> f32 {
    let size = pow(max(abs(x), 1e-30), exponent);
    return sign(x) * min(size, 1e24);
}

/// power_vec2(vec2f(4.0, -2.0), vec2f(0.5, 3.0)) == vec2f(2.0, -8.0) +- 1e-4
/// -> The power. -1000000000000000000000000..1000000000000000000000000
fn power_vec2(
    /// The base. -1000..1000
    x: vec2f,
    /// The exponent. 0.01..8 = (2.0, 2.0)
    exponent: vec2f,
) -> vec2f {
    let size = pow(max(abs(x), vec2f(1e-30)), exponent);
    return sign(x) * min(size, vec2f(1e24));
}

/// power_vec3(vec3f(4.0, -2.0, 0.25), vec3f(0.5, 3.0, 2.0)) == vec3f(2.0, -8.0, 0.0625) +- 1e-4
/// -> The power. -1000000000000000000000000..1000000000000000000000000
fn power_vec3(
    /// The base. -1000..1000
    x: vec3f,
    /// The exponent. 0.01..8 = (2.0, 2.0, 2.0)
    exponent: vec3f,
) -> vec3f {
    let size = pow(max(abs(x), vec3f(1e-30)), exponent);
    return sign(x) * min(size, vec3f(1e24));
}

/// power_vec4(vec4f(4.0, -2.0, 0.25, 0.0), vec4f(0.5, 3.0, 2.0, 0.7)) == vec4f(2.0, -8.0, 0.0625, 0.0) +- 1e-4
/// -> The power. -1000000000000000000000000..1000000000000000000000000
fn power_vec4(
    /// The base. -1000..1000
    x: vec4f,
    /// The exponent. 0.01..8 = (2.0, 2.0, 2.0, 2.0)
    exponent: vec4f,
) -> vec4f {
    let size = pow(max(abs(x), vec4f(1e-30)), exponent);
    return sign(x) * min(size, vec4f(1e24));
}
