//! What a place tells its material.

/// What a material may ask for.
struct HostFrame {
    position: Place,
    terrain_uv: Coord,
    height: f32,
    slope: f32,
    normal: vec3f,
    curvature: f32,
    distance: f32,
    sun: vec3f,
}
