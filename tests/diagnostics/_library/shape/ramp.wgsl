//! A straight ramp from 0 to 1.
//! Source: test.

/// ramp(0.5, 0.0, 1.0) == 0.5 +- 0.0
/// -> The height of the ramp. 0..1
fn ramp(
    /// What to look at.
    x: f32,
    /// Where the ramp is 0.
    low: f32,
    /// Where the ramp is 1.
    high: f32,
) -> f32 {
    return clamp((x - low) / (high - low), 0.0, 1.0);
}
