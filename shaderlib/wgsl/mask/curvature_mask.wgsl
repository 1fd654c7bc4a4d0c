//! Ridges light, hollows dark, even ground in the middle: for worn edges and dirt in one.
//! Source: Zevenbergen and Thorne, "Quantitative Analysis of Land Surface Topography", 1987 (curvature as a terrain attribute).

/// curvature_mask(0.0, 50.0) == 0.5 +- 0
/// curvature_mask(0.01, 50.0) == 0.75 +- 1e-6
/// curvature_mask(-1.0, 50.0) == 0.0 +- 0
/// -> 0.5 on even ground. 0..1
fn curvature_mask(
    /// Positive on ridges, negative in hollows. [1/m] -100..100
    curvature: f32,
    /// Radius at which the mask is 0 or 1. [m] 0.1..10000 = 50.0
    radius: f32,
) -> f32 {
    return saturate(0.5 + 0.5 * curvature * radius);
}
