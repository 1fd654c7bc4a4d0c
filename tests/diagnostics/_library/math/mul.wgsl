//! Product.
//! Source: test.

/// mul_f32(2.0, 3.0) == 6.0 +- 0.0
/// -> The product.
fn mul_f32(
    /// One factor.
    a: f32,
    /// The other.
    b: f32,
) -> f32 {
    return a * b;
}

/// mul_vec3(vec3f(2.0), vec3f(3.0)) == vec3f(6.0) +- 0.0
/// -> The product.
fn mul_vec3(
    /// One factor.
    a: vec3f,
    /// The other.
    b: vec3f,
) -> vec3f {
    return a * b;
}
