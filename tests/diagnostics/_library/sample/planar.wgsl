//! Texture coordinates from above.
//! Source: test.

/// planar(Place(vec2i(0), vec3f(0.0), vec3f(0.0), vec3f(0.0)), 1.0).uv.x == 0.0 +- 0.0
/// -> The coordinates.
fn planar(
    /// Where.
    position: Place,
    /// Size of one repetition. [m] 0.001..10000
    tile: f32,
) -> Coord {
    return Coord(position.local.xz / tile, position.ddx.xz / tile, position.ddy.xz / tile);
}
