//! Gradient noise and its exact slope, without a second evaluation: for normals, and for warping with true gradients.
//! Source: Quilez, "Gradient Noise Derivatives", 2017.

/// Gradient noise with its slope.
struct GradientNoiseDerivative {
    /// As `gradient_noise` gives it. 0..1
    value: f32,
    /// Rise per metre to the east and to the south. [1/m] -400..400
    slope: vec2f,
}

/// gradient_noise_derivative(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u).value == 0.4360672 +- 1e-5
/// gradient_noise_derivative(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u).slope == vec2f(0.0584745, -0.0889489) +- 1e-5
fn gradient_noise_derivative(
    /// Where.
    position: Place,
    /// Size of a wave. [m] 0.01..16384 = 8.0
    wavelength: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> GradientNoiseDerivative {
    let noise = gradient_noise_derivative_at(place_lattice(position, wavelength), seed);
    return GradientNoiseDerivative(saturate(0.5 + 0.5 * noise.x), 0.5 * noise.yz / wavelength);
}

/// Value -1..1, and change per cell along x and z.
fn gradient_noise_derivative_at(lattice: Lattice, seed: u32) -> vec3f {
    let f = lattice.fraction;
    let fade = lattice_fade(f);
    let rise = lattice_fade_slope(f);
    let a = gradient_noise_derivative_corner(lattice.cell, vec2i(0, 0), f, seed);
    let b = gradient_noise_derivative_corner(lattice.cell, vec2i(1, 0), f, seed);
    let c = gradient_noise_derivative_corner(lattice.cell, vec2i(0, 1), f, seed);
    let d = gradient_noise_derivative_corner(lattice.cell, vec2i(1, 1), f, seed);
    let twist = a - b - c + d;
    let plane = a + fade.x * (b - a) + fade.y * (c - a) + fade.x * fade.y * twist;
    let bend = rise * (vec2f(b.x - a.x, c.x - a.x) + fade.yx * twist.x);
    return 1.4142135 * (plane + vec3f(0.0, bend));
}

/// The plane through one corner: its value here, and its slope.
fn gradient_noise_derivative_corner(cell: vec2i, corner: vec2i, f: vec2f, seed: u32) -> vec3f {
    let slope = hash_direction(lattice_hash(cell + corner, seed).x);
    return vec3f(dot(slope, f - vec2f(corner)), slope);
}
