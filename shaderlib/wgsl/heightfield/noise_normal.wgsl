//! The normal of fractal noise in one step: fine relief without any texture.
//! Source: Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978; Quilez, "Gradient Noise Derivatives", 2017.

/// noise_normal(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u, 0.5, 0.0, 3u) == vec3f(0.0, 0.0, 1.0) +- 1e-6
/// noise_normal(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u, 0.5, 2.0, 3u) == vec3f(-0.0956035, -0.3734075, 0.9227279) +- 1e-5
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn noise_normal(
    /// Where.
    position: Place,
    /// Size of the largest waves. [m] 0.01..16384 = 1.0
    wavelength: f32,
    /// How many sizes of waves, each 2.24 times smaller. const 1..10 = 3
    octaves: u32,
    /// Height of a wave over that of the next larger. 0..1 = 0.5
    persistence: f32,
    /// Height from the deepest to the highest point. [m] 0..1000 = 0.05
    depth: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> vec3f {
    return normal_from_slope(fbm_derivative(position, wavelength, octaves, persistence, seed).slope, depth);
}
