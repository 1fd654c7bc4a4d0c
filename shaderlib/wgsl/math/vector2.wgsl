//! Makes a vector of two numbers.
//! Source: W3C, "WebGPU Shading Language", section 17.1 (constructors).

/// vector2(0.5, -1.0) == vec2f(0.5, -1.0) +- 0
/// -> The vector. -1000000..1000000
fn vector2(
    /// Its first component. -1000000..1000000 = 0.0
    x: f32,
    /// Its second component. -1000000..1000000 = 0.0
    y: f32,
) -> vec2f {
    return vec2f(x, y);
}
