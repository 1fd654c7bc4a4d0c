//! 1 where pixels are small enough to show details of a size, 0 where they are not: independent of resolution and lens.
//! Source: Norton, Rockwood and Skolmoski, "Clamping: A Method of Antialiasing Textured Surfaces by Bandwidth Limiting in Object Space", SIGGRAPH 1982.

/// footprint_mask(Place(vec2i(0, 0), vec3f(0.0), vec3f(0.1, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 2.0) == 1.0 +- 0
/// footprint_mask(Place(vec2i(0, 0), vec3f(0.0), vec3f(0.5, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 1.5) == 0.5 +- 1e-6
/// footprint_mask(Place(vec2i(0, 0), vec3f(0.0), vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 1.5) == 0.0 +- 0
/// -> 1 from four pixels a detail on, 0 under two. 0..1
fn footprint_mask(
    /// Where.
    position: Place,
    /// Size of the detail. [m] 0.001..16384 = 0.5
    size: f32,
) -> f32 {
    return lattice_kept(size, place_footprint(position));
}
