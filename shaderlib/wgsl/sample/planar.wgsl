//! Texture coordinates seen from above: u runs east, v south, one tile is `tile` metres wide.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, section 5.2 (tiled detail maps).

/// planar(Place(vec2i(1024, 0), vec3f(1.0, 9.0, 3.0), vec3f(0.5, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 4.0).uv == vec2f(1.25, 0.75) +- 1e-6
/// planar(Place(vec2i(-1024, 0), vec3f(0.0, 9.0, 0.0), vec3f(0.5, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 4.0).ddx == vec2f(0.125, 0.0) +- 1e-6
/// -> For `texture` and its relatives.
fn planar(
    /// Where.
    position: Place,
    /// Side of one tile. [m] 0.01..16384 = 4.0
    tile: f32,
) -> Coord {
    return place_coord(position, tile);
}
