/// Where on the terrain.
struct Place {
    /// The patch's corner in 1/256 m.
    origin: vec2i,
    /// Metres from that corner.
    local: vec3f,
    /// Change of the position per pixel to the right.
    ddx: vec3f,
    /// Change of the position per pixel down.
    ddy: vec3f,
}
