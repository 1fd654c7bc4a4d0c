//! The cosine of an angle, good far beyond the pi where WGSL's own ends.
//! Source: Abramowitz and Stegun, "Handbook of Mathematical Functions", 1964, 4.3.66.

/// cosine(1.0471976) == 0.5 +- 1e-5
/// cosine(0.0) == 1.0 +- 0
/// cosine(20.0) == 0.4080821 +- 1e-5
/// -> The cosine. -1..1
fn cosine(
    /// The angle. [rad] -1000..1000
    angle: f32,
) -> f32 {
    return angle_unit(angle * 57.29578).x;
}
