//! The sine of an angle, good far beyond the pi where WGSL's own ends.
//! Source: Abramowitz and Stegun, "Handbook of Mathematical Functions", 1964, 4.3.65.

/// sine(0.5235988) == 0.5 +- 1e-5
/// sine(-1.5707963) == -1.0 +- 1e-5
/// sine(20.0) == 0.9129453 +- 1e-5
/// -> The sine. -1..1
fn sine(
    /// The angle. [rad] -1000..1000
    angle: f32,
) -> f32 {
    return angle_unit(angle * 57.29578).y;
}
