//! Random numbers on a grid, smoothly joined: the cheapest noise, a little blocky.
//! Source: Ebert et al., "Texturing and Modeling: A Procedural Approach", 3rd edition, 2003, chapter 2 (lattice noises); Perlin, "Improving Noise", 2002 (the fade).

/// value_noise(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u) == 0.8367859 +- 1e-5
/// value_noise(Place(vec2i(1024000, -512000), vec3f(3.0, 5.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 7u) == 0.2739201 +- 1e-5
/// -> Evenly spread at the grid's corners, towards the middle between them. 0..1
fn value_noise(
    /// Where.
    position: Place,
    /// Distance between two random numbers. [m] 0.01..16384 = 8.0
    wavelength: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> f32 {
    return value_noise_at(place_lattice(position, wavelength), seed);
}

/// The noise at a point of a grid, 0..1.
fn value_noise_at(lattice: Lattice, seed: u32) -> f32 {
    let corners = value_noise_corners(lattice.cell, seed);
    let fade = lattice_fade(lattice.fraction);
    let edges = mix(corners.xz, corners.yw, vec2f(fade.x));
    return saturate(mix(edges.x, edges.y, fade.y));
}

/// Random numbers at north-west, north-east, south-west and south-east of a cell.
fn value_noise_corners(cell: vec2i, seed: u32) -> vec4f {
    return vec4f(
        hash_unit(lattice_hash(cell, seed).x),
        hash_unit(lattice_hash(cell + vec2i(1, 0), seed).x),
        hash_unit(lattice_hash(cell + vec2i(0, 1), seed).x),
        hash_unit(lattice_hash(cell + vec2i(1, 1), seed).x),
    );
}
