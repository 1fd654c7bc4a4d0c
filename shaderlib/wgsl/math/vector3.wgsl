//! Makes a vector of three numbers, or a colour of red, green and blue.
//! Source: W3C, "WebGPU Shading Language", section 17.1 (constructors).

/// vector3(0.5, -1.0, 2.0) == vec3f(0.5, -1.0, 2.0) +- 0
/// -> The vector. -1000000..1000000
fn vector3(
    /// Its first component. -1000000..1000000 = 0.0
    x: f32,
    /// Its second component. -1000000..1000000 = 0.0
    y: f32,
    /// Its third component. -1000000..1000000 = 0.0
    z: f32,
) -> vec3f {
    return vec3f(x, y, z);
}
