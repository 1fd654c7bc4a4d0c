//! A chessboard on the ground: to see scale, and where a mask lies.
//! Source: Quilez, "Filtering the Checkerboard Pattern", 2017 (fades to grey where squares are smaller than pixels).

/// checker(Place(vec2i(0, 0), vec3f(1.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 2.0) == 0.0 +- 0
/// checker(Place(vec2i(-1, 0), vec3f(0.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 2.0) == 1.0 +- 0
/// -> 0 or 1 from square to square. 0..1
fn checker(
    /// Where.
    position: Place,
    /// Side of a square. [m] 0.01..16384 = 1.0
    size: f32,
) -> f32 {
    let cell = place_lattice(position, size).cell;
    let odd = f32((cell.x + cell.y) & 1);
    return mix(0.5, odd, lattice_kept(size, place_footprint(position)));
}
