//! Repeats texture coordinates more often. Only whole factors keep tiles whole; for other sizes ask `planar` for another tile.
//! Source: Terrane.

/// uv_scale(Coord(vec2f(0.25, 0.5), vec2f(0.125, 0.0), vec2f(0.0, 0.25)), 4).uv == vec2f(1.0, 2.0) +- 0
/// uv_scale(Coord(vec2f(0.25, 0.5), vec2f(0.125, 0.0), vec2f(0.0, 0.25)), 4).ddy == vec2f(0.0, 1.0) +- 0
/// -> The scaled coordinates.
fn uv_scale(
    /// What to repeat.
    uv: Coord,
    /// How often. 1..64 = 2
    times: i32,
) -> Coord {
    let factor = f32(times);
    return Coord(uv.uv * factor, uv.ddx * factor, uv.ddy * factor);
}
