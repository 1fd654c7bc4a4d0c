//! Makes a vector of four numbers.
//! Source: W3C, "WebGPU Shading Language", section 17.1 (constructors).

/// vector4(0.5, -1.0, 2.0, 4.0) == vec4f(0.5, -1.0, 2.0, 4.0) +- 0
/// -> The vector. -1000000..1000000
fn vector4(
    /// Its first component. -1000000..1000000 = 0.0
    x: f32,
    /// Its second component. -1000000..1000000 = 0.0
    y: f32,
    /// Its third component. -1000000..1000000 = 0.0
    z: f32,
    /// Its fourth component. -1000000..1000000 = 1.0
    w: f32,
) -> vec4f {
    return vec4f(x, y, z, w);
}
