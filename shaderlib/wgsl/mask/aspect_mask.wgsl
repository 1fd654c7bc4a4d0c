//! Where the ground faces a compass direction; flat ground faces none.
//! Source: Horn, "Hill Shading and the Reflectance Map", 1981 (aspect of a surface); the fade is Terrane's.

/// aspect_mask(vec3f(0.6, 0.8, 0.0), 90.0, 60.0) == 1.0 +- 1e-5
/// aspect_mask(vec3f(-0.6, 0.8, 0.0), 90.0, 60.0) == 0.0 +- 1e-5
/// aspect_mask(vec3f(0.0, 0.8, -0.6), 0.0, 90.0) == 1.0 +- 1e-5
/// aspect_mask(vec3f(0.0, 0.8, 0.6), 90.0, 120.0) == 0.5 +- 1e-3
/// aspect_mask(vec3f(0.0, 1.0, 0.0), 0.0, 90.0) == 0.0 +- 0
/// -> 1 where it faces that way. 0..1
fn aspect_mask(
    /// The ground's, in world space, y up. -1..1
    normal: vec3f,
    /// The direction, clockwise from north. [deg] -360..360 = 0.0
    azimuth: f32,
    /// How far away from it the mask ends; it is full within half of that. [deg] 1..180 = 90.0
    width: f32,
) -> f32 {
    let way = angle_unit(azimuth);
    let steep = sqrt(max(dot(normal.xz, normal.xz), 1e-12));
    let facing = (normal.x * way.y - normal.z * way.x) / max(steep, 1e-6);
    let off = acos(clamp(facing, -1.0, 1.0)) * 57.29578;
    return ramp_smooth(off, width, 0.5 * width) * ramp_smooth(steep, 0.02, 0.1);
}
