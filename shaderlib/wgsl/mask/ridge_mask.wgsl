//! Where the ground bulges: ridges, edges, brows that wind and frost keep bare.
//! Source: Zevenbergen and Thorne, "Quantitative Analysis of Land Surface Topography", 1987 (curvature as a terrain attribute).

/// ridge_mask(0.01, 50.0) == 0.5 +- 1e-6
/// ridge_mask(-0.01, 50.0) == 0.0 +- 0
/// -> 1 on ridges as sharp as the radius or sharper. 0..1
fn ridge_mask(
    /// Positive on ridges, negative in hollows. [1/m] -100..100
    curvature: f32,
    /// Radius at which the mask is full. [m] 0.1..10000 = 50.0
    radius: f32,
) -> f32 {
    return saturate(curvature * radius);
}
