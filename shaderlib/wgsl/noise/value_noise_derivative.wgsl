//! Value noise and its exact slope, without a second evaluation.
//! Source: Quilez, "Value Noise Derivatives", 2008, with Perlin's quintic fade.

/// Value noise with its slope.
struct ValueNoiseDerivative {
    /// As `value_noise` gives it. 0..1
    value: f32,
    /// Rise per metre to the east and to the south. [1/m] -200..200
    slope: vec2f,
}

/// value_noise_derivative(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u).value == 0.8367859 +- 1e-5
/// value_noise_derivative(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u).slope == vec2f(-0.0917042, -0.0243570) +- 1e-5
fn value_noise_derivative(
    /// Where.
    position: Place,
    /// Distance between two random numbers. [m] 0.01..16384 = 8.0
    wavelength: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> ValueNoiseDerivative {
    let noise = value_noise_derivative_at(place_lattice(position, wavelength), seed);
    return ValueNoiseDerivative(saturate(noise.x), noise.yz / wavelength);
}

/// Value, and change per cell along x and z.
fn value_noise_derivative_at(lattice: Lattice, seed: u32) -> vec3f {
    let corners = value_noise_corners(lattice.cell, seed);
    let fade = lattice_fade(lattice.fraction);
    let rise = lattice_fade_slope(lattice.fraction);
    let north = corners.y - corners.x;
    let west = corners.z - corners.x;
    let twist = corners.x - corners.y - corners.z + corners.w;
    let value = corners.x + north * fade.x + west * fade.y + twist * fade.x * fade.y;
    return vec3f(value, rise * (vec2f(north, west) + twist * fade.yx));
}
