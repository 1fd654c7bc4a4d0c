//! How far one vector goes along another, times both lengths.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): dot.

/// dot_product_vec2(vec2f(1.5, -2.0), vec2f(0.5, 4.0)) == -7.25 +- 1e-6
/// -> The sum of the products. -4000000..4000000
fn dot_product_vec2(
    /// One vector. -1000..1000
    a: vec2f,
    /// The other one. -1000..1000
    b: vec2f,
) -> f32 {
    return dot(a, b);
}

/// dot_product_vec3(vec3f(1.5, -2.0, 0.25), vec3f(0.5, 4.0, -1.0)) == -7.5 +- 1e-6
/// -> The sum of the products. -4000000..4000000
fn dot_product_vec3(
    /// One vector. -1000..1000
    a: vec3f,
    /// The other one. -1000..1000
    b: vec3f,
) -> f32 {
    return dot(a, b);
}

/// dot_product_vec4(vec4f(1.5, -2.0, 0.25, 8.0), vec4f(0.5, 4.0, -1.0, 2.0)) == 8.5 +- 1e-6
/// -> The sum of the products. -4000000..4000000
fn dot_product_vec4(
    /// One vector. -1000..1000
    a: vec4f,
    /// The other one. -1000..1000
    b: vec4f,
) -> f32 {
    return dot(a, b);
}
