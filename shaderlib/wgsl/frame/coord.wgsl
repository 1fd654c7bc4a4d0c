//! Texture coordinates that carry their screen gradients, so that a texture may be read inside any branch.
//! Source: W3C, "WebGPU Shading Language", section 15.2 (uniformity): implicit derivatives are not allowed there.

/// Texture coordinates with their screen gradients.
struct Coord {
    /// One unit is one tile.
    uv: vec2f,
    /// Change per pixel to the right.
    ddx: vec2f,
    /// Change per pixel down.
    ddy: vec2f,
}

/// The size of a pixel in tiles, along its longer side.
fn coord_footprint(uv: Coord) -> f32 {
    // WGSL derives a square root from the inverse one, and promises nothing for 0.
    return sqrt(max(max(dot(uv.ddx, uv.ddx), dot(uv.ddy, uv.ddy)), 1e-24));
}
