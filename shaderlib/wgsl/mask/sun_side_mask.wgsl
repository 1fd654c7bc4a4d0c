//! Sunny and shady slopes of a latitude, whatever the hour of the scene: where snow stays and moss grows.
//! The sun stands as at noon of an equinox: due south in the northern hemisphere, 90 degrees minus the latitude high.
//! Source: Duffie and Beckman, "Solar Engineering of Thermal Processes", section 1.6 (direction of beam radiation).

/// sun_side_mask(vec3f(0.0, 1.0, 0.0), 45.0, 1.0) == 0.5 +- 1e-6
/// sun_side_mask(vec3f(0.0, 0.8, 0.6), 45.0, 1.0) == 0.7828427 +- 1e-5
/// sun_side_mask(vec3f(0.0, 0.8, 0.6), -45.0, 0.5) == 0.2171573 +- 1e-5
/// -> 0.5 on flat ground, more on the sunny side. 0..1
fn sun_side_mask(
    /// The ground's, in world space, y up. -1..1
    normal: vec3f,
    /// North is positive. [deg] -90..90 = 45.0
    latitude: f32,
    /// How quickly the mask leaves 0.5. 0..8 = 1.0
    strength: f32,
) -> f32 {
    let way = angle_unit(latitude);
    let received = normal.y * way.x + normal.z * way.y;
    return saturate(0.5 + strength * (received - way.x));
}
