//! Where the ground is hollow: gullies and foots of slopes, where water, snow and soil gather.
//! Source: Zevenbergen and Thorne, "Quantitative Analysis of Land Surface Topography", 1987 (curvature as a terrain attribute).

/// cavity_mask(-0.01, 50.0) == 0.5 +- 1e-6
/// cavity_mask(0.01, 50.0) == 0.0 +- 0
/// -> 1 on hollows as sharp as the radius or sharper. 0..1
fn cavity_mask(
    /// Positive on ridges, negative in hollows. [1/m] -100..100
    curvature: f32,
    /// Radius at which the mask is full. [m] 0.1..10000 = 50.0
    radius: f32,
) -> f32 {
    return saturate(-curvature * radius);
}
