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
    // 1 - cos a = 2 sin^2 (a / 2): unlike the arc cosine of something near 1 this keeps its precision on flat ground.
    let half_sine = sqrt(clamp(0.5 * slope, 1e-12, 0.5));
    return ramp_smooth(2.0 * asin(half_sine) * 57.29578, low, high);
}
