//! Octaves of noise.
//! Source: test.

/// fbm(Place(vec2i(0), vec3f(0.0), vec3f(0.0), vec3f(0.0)), 8.0, 4, 0u) == 0.5 +- 1.0
/// -> The sum. 0..1
fn fbm(
    /// Where.
    position: Place,
    /// Length of the longest wave. [m] 0.01..100000
    wavelength: f32,
    /// How many. const 1..8 = 4
    octaves: i32,
    /// Another number, another noise. = 0
    seed: u32,
) -> f32 {
    return fract(position.local.x / wavelength + f32(octaves) + f32(seed));
}
