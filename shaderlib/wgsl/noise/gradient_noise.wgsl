//! Perlin's noise: random slopes on a grid, smoothly joined. The base of clouds of grass, dirt and rock.
//! Source: Perlin, "Improving Noise", SIGGRAPH 2002 (quintic fade); the slopes are unit vectors of any direction.

/// gradient_noise(Place(vec2i(-2048000000, 2048), vec3f(0.0), vec3f(0.0), vec3f(0.0)), 8.0, 1u) == 0.5 +- 1e-6
/// gradient_noise(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u) == 0.4360672 +- 1e-5
/// gradient_noise(Place(vec2i(1024000, -512000), vec3f(3.0, 5.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 7u) == 0.4261413 +- 1e-5
/// -> 0.5 on the grid's corners, waves of about one wavelength between them. 0..1
fn gradient_noise(
    /// Where.
    position: Place,
    /// Size of a wave. [m] 0.01..16384 = 8.0
    wavelength: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> f32 {
    return saturate(0.5 + 0.5 * gradient_noise_at(place_lattice(position, wavelength), seed));
}

/// The noise at a point of a grid, -1..1, mean 0.
///
/// Four unit slopes whose corners are |d| away give at most the weighted mean of |d|, which is largest in the middle
/// of the cell: sqrt(1/2). Hence the factor.
fn gradient_noise_at(lattice: Lattice, seed: u32) -> f32 {
    let f = lattice.fraction;
    let fade = lattice_fade(f);
    let north = mix(
        gradient_noise_corner(lattice.cell, vec2i(0, 0), f, seed),
        gradient_noise_corner(lattice.cell, vec2i(1, 0), f, seed),
        fade.x,
    );
    let south = mix(
        gradient_noise_corner(lattice.cell, vec2i(0, 1), f, seed),
        gradient_noise_corner(lattice.cell, vec2i(1, 1), f, seed),
        fade.x,
    );
    return 1.4142135 * mix(north, south, fade.y);
}

/// The plane through one corner.
fn gradient_noise_corner(cell: vec2i, corner: vec2i, f: vec2f, seed: u32) -> f32 {
    return dot(hash_direction(lattice_hash(cell + corner, seed).x), f - vec2f(corner));
}
