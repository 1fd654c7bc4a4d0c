/// Texture coordinates with their screen gradients.
struct Coord {
    /// Where in the texture.
    uv: vec2f,
    /// Change per pixel to the right.
    ddx: vec2f,
    /// Change per pixel down.
    ddy: vec2f,
}
