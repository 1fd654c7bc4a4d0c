//! The normal of a slope: of a noise with derivatives, scaled to its height in metres.
//! Source: Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978 (normals from the height's partial derivatives).

/// normal_from_slope(vec2f(0.75, 0.0), 1.0) == vec3f(-0.6, 0.0, 0.8) +- 1e-5
/// normal_from_slope(vec2f(0.0, 0.1), 7.5) == vec3f(0.0, -0.6, 0.8) +- 1e-5
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn normal_from_slope(
    /// Rise per metre to the east and to the south. [1/m] -1000000..1000000
    slope: vec2f,
    /// Height that a value of 1 stands for. [m] 0..1000 = 1.0
    depth: f32,
) -> vec3f {
    return layer_normal(clamp(-slope * depth, vec2f(-1e6), vec2f(1e6)));
}
