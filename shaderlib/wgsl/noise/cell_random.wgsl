//! One random number for each square of the ground: variation from plot to plot, or white noise when the squares are small.
//! Source: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020 (pcg3d).

/// cell_random(Place(vec2i(0, 0), vec3f(1.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 0u) == 0.60815185 +- 1e-6
/// cell_random(Place(vec2i(-4096, 2048), vec3f(1.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 7u) == 0.91775692 +- 1e-6
/// -> Every value is equally likely. 0..1
fn cell_random(
    /// Where.
    position: Place,
    /// Side of a square. [m] 0.01..16384 = 4.0
    size: f32,
    /// Another seed gives other numbers. 0..65535 = 0
    seed: u32,
) -> f32 {
    return hash_unit(lattice_hash(place_lattice(position, size).cell, seed).x);
}
