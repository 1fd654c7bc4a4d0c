//! Moves texture coordinates, so that two uses of one texture do not fall together.
//! Source: Terrane.

/// uv_offset(Coord(vec2f(0.25, 0.5), vec2f(0.125, 0.0), vec2f(0.0, 0.25)), vec2f(0.5, -0.25)).uv == vec2f(0.75, 0.25) +- 0
/// uv_offset(Coord(vec2f(0.25, 0.5), vec2f(0.125, 0.0), vec2f(0.0, 0.25)), vec2f(0.5, -0.25)).ddx == vec2f(0.125, 0.0) +- 0
/// -> The moved coordinates.
fn uv_offset(
    /// What to move.
    uv: Coord,
    /// How far, in tiles. -1..1 = (0.5, 0.5)
    offset: vec2f,
) -> Coord {
    return Coord(uv.uv + offset, uv.ddx, uv.ddy);
}
