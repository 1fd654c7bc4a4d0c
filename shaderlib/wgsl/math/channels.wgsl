//! Takes a colour or vector apart.
//! Source: W3C, "WebGPU Shading Language", section 8.5 (component access).

/// The four numbers of a vector.
struct Channels {
    /// The first. -1000000..1000000
    r: f32,
    /// The second. -1000000..1000000
    g: f32,
    /// The third. -1000000..1000000
    b: f32,
    /// The fourth. -1000000..1000000
    a: f32,
}

/// channels(vec4f(0.5, -1.0, 2.0, 4.0)).g == -1.0 +- 0
/// channels(vec4f(0.5, -1.0, 2.0, 4.0)).a == 4.0 +- 0
fn channels(
    /// What to take apart. -1000000..1000000
    v: vec4f,
) -> Channels {
    return Channels(v.r, v.g, v.b, v.a);
}
