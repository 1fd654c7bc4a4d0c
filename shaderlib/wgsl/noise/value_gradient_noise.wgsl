//! Gradient noise with random heights at the grid's corners: as lively there as between them, so no grid of quiet points shows.
//! Source: Peachey, in Ebert et al., "Texturing and Modeling: A Procedural Approach", 3rd edition, 2003, chapter 2 (value-gradient noises); Quilez, "Gradient Noise Derivatives", 2017.

/// value_gradient_noise(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u) == 0.4007538 +- 1e-5
/// value_gradient_noise(Place(vec2i(1024000, -512000), vec3f(3.0, 5.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 7u) == 0.4811624 +- 1e-5
/// -> Waves of about one wavelength around 0.5. 0..1
fn value_gradient_noise(
    /// Where.
    position: Place,
    /// Size of a wave. [m] 0.01..16384 = 8.0
    wavelength: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> f32 {
    return saturate(0.5 + 0.5 * value_gradient_noise_at(place_lattice(position, wavelength), seed));
}

/// Share of the heights: 1/2 makes the variance at a corner, 1/3 of its square, equal to that in the middle, 1/16 + 1/12 of its square.
const VALUE_GRADIENT_NOISE_HEIGHT: f32 = 0.5;

/// One over the largest sum: sqrt(1/2) of the slopes and 1/2 of the heights.
const VALUE_GRADIENT_NOISE_SCALE: f32 = 0.82842714;

/// The noise at a point of a grid, -1..1, mean 0.
fn value_gradient_noise_at(lattice: Lattice, seed: u32) -> f32 {
    let f = lattice.fraction;
    let fade = lattice_fade(f);
    let a = value_gradient_noise_corner(lattice.cell, vec2i(0, 0), f, seed);
    let b = value_gradient_noise_corner(lattice.cell, vec2i(1, 0), f, seed);
    let c = value_gradient_noise_corner(lattice.cell, vec2i(0, 1), f, seed);
    let d = value_gradient_noise_corner(lattice.cell, vec2i(1, 1), f, seed);
    return VALUE_GRADIENT_NOISE_SCALE * mix(mix(a.x, b.x, fade.x), mix(c.x, d.x, fade.x), fade.y);
}

/// The noise, and its change per cell along x and z.
fn value_gradient_noise_slope_at(lattice: Lattice, seed: u32) -> vec3f {
    let f = lattice.fraction;
    let fade = lattice_fade(f);
    let rise = lattice_fade_slope(f);
    let a = value_gradient_noise_corner(lattice.cell, vec2i(0, 0), f, seed);
    let b = value_gradient_noise_corner(lattice.cell, vec2i(1, 0), f, seed);
    let c = value_gradient_noise_corner(lattice.cell, vec2i(0, 1), f, seed);
    let d = value_gradient_noise_corner(lattice.cell, vec2i(1, 1), f, seed);
    let north = mix(a, b, fade.x);
    let south = mix(c, d, fade.x);
    let bend = rise * vec2f(mix(b.x - a.x, d.x - c.x, fade.y), south.x - north.x);
    return VALUE_GRADIENT_NOISE_SCALE * (mix(north, south, fade.y) + vec3f(0.0, bend));
}

/// The plane through one corner: its value here, and its slope.
fn value_gradient_noise_corner(cell: vec2i, corner: vec2i, f: vec2f, seed: u32) -> vec3f {
    let random = lattice_hash(cell + corner, seed);
    let slope = hash_direction(random.x);
    let height = VALUE_GRADIENT_NOISE_HEIGHT * (2.0 * hash_unit(random.y) - 1.0);
    return vec3f(height + dot(slope, f - vec2f(corner)), slope);
}
