//! Planar texture coordinates turned about the vertical: lays rows, ripples and bedding in a direction, breaks up repetition.
//! The direction keeps to steps of about 0.06 degrees, and the phase is kept in whole numbers: no seam between patches.
//! Source: Terrane; fixed-point phase accumulation as in direct digital synthesis (Tierney, Rader and Gold, "A Digital Frequency Synthesizer", 1971).

/// rotated(Place(vec2i(0, 0), vec3f(1.0, 0.0, 3.0), vec3f(0.5, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 4.0, 0.0).uv == vec2f(0.25, 0.75) +- 1e-6
/// rotated(Place(vec2i(0, 0), vec3f(1.0, 0.0, 3.0), vec3f(0.5, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 4.0, 90.0).uv == vec2f(0.75, -0.25) +- 1e-6
/// rotated(Place(vec2i(0, 0), vec3f(1.0, 0.0, 3.0), vec3f(0.5, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 4.0, 90.0).ddx == vec2f(0.0, -0.125) +- 1e-6
/// rotated(Place(vec2i(2048, 0), vec3f(0.0, 0.0, 0.0), vec3f(0.0), vec3f(0.0)), 8.0, 90.0).uv == vec2f(0.0, -1.0) +- 1e-6
/// -> Coordinates whose v runs south turned clockwise by the angle.
fn rotated(
    /// Where.
    position: Place,
    /// Side of one tile. [m] 0.05..1024 = 4.0
    tile: f32,
    /// Clockwise, seen from above. [deg] -360..360 = 0.0
    angle: f32,
) -> Coord {
    let period = place_periods(vec2f(tile)).x;
    let way = vec2i(round(angle_unit(angle) * ROTATED_STEPS));
    // Turns of a 32-bit phase per unit of ground: 2^32 is two tiles. 1024 * 2^21 fits, and overflow of the sum is the wrap that is wanted.
    let speed = vec2i(sign(vec2f(way))) * bitcast<vec2i>(vec2u(abs(way)) * 2097152u / vec2u(u32(period)));
    let units = position.local.xz * PLACE_UNITS;
    let corner = position.origin;
    let phase = vec2i(
        corner.x * speed.x + corner.y * speed.y,
        corner.y * speed.x - corner.x * speed.y,
    );
    // The phase at the corner, and from there in floats with the same speed.
    let tiles = vec2f(speed) * ROTATED_TILES;
    let turn = mat2x2f(tiles.x, -tiles.y, tiles.y, tiles.x);
    return Coord(
        vec2f(phase) * ROTATED_TILES + turn * units,
        turn * (position.ddx.xz * PLACE_UNITS),
        turn * (position.ddy.xz * PLACE_UNITS),
    );
}

/// A direction's cosine and sine are whole multiples of 1/1024.
const ROTATED_STEPS: f32 = 1024.0;

/// Tiles in one step of the phase: 2 / 2^32.
const ROTATED_TILES: f32 = 0.00000000046566128730773926;
