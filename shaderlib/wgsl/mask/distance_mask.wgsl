//! 1 near the eye, 0 far away: hands over from fine detail to macro variation.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, section 5.1 (detail maps blended in by distance).

/// distance_mask(50.0, 100.0, 200.0) == 1.0 +- 0
/// distance_mask(150.0, 100.0, 200.0) == 0.5 +- 1e-6
/// distance_mask(900.0, 100.0, 200.0) == 0.0 +- 0
/// -> Falls from near to far. 0..1
fn distance_mask(
    /// From the eye. [m] 0..1000000
    distance: f32,
    /// Up to here the mask is 1. [m] 0..1000000 = 50.0
    near: f32,
    /// From here on it is 0. [m] 0..1000000 = 200.0
    far: f32,
) -> f32 {
    return ramp_smooth(distance, far, near);
}
