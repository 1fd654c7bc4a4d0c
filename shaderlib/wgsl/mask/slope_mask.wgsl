//! Where the ground is steep, by its angle; with `low` above `high`, where it is flat.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, section 5.2.3.

/// slope_mask(0.5, 30.0, 90.0) == 0.5 +- 1e-3
/// slope_mask(0.0, 30.0, 45.0) == 0.0 +- 0
/// slope_mask(0.0, 20.0, 10.0) == 1.0 +- 0
/// -> 0 at low, 1 at high. 0..1
fn slope_mask(
    /// 1 minus the upward part of the normal: 0 is flat, 1 is a wall. 0..1
    slope: f32,
    /// Angle at which the mask is still 0. [deg] 0..90 = 30.0
    low: f32,
    /// Angle at which it is 1. [deg] 0..90 = 45.0
    high: f32,
) -> f32 {
    let angle = acos(clamp(1.0 - slope, 0.0, 1.0)) * 57.29578;
    return ramp_smooth(angle, low, high);
}
