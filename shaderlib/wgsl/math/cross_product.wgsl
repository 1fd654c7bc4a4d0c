//! The vector that stands on two others.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions): cross.

/// cross_product(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0)) == vec3f(0.0, 0.0, 1.0) +- 0
/// cross_product(vec3f(1.0, 2.0, 3.0), vec3f(4.0, 5.0, 6.0)) == vec3f(-3.0, 6.0, -3.0) +- 1e-5
/// -> As long as the area between both. -2000001..2000001
fn cross_product(
    /// One vector. -1000..1000
    a: vec3f,
    /// The other one. -1000..1000
    b: vec3f,
) -> vec3f {
    return cross(a, b);
}
