//! Carries a range onto another one, held at both ends; either may be reversed.
//! Source: Terrane; linear interpolation.

/// remap(15.0, 10.0, 20.0, 0.0, 4.0) == 2.0 +- 1e-6
/// remap(25.0, 10.0, 20.0, 4.0, 1.0) == 1.0 +- 1e-6
/// -> Between the two ends of the new range. -1000000..1000000
fn remap(
    /// The value to carry over. -1000000..1000000
    x: f32,
    /// Start of the old range. -1000000..1000000 = 0.0
    from_low: f32,
    /// End of the old range. -1000000..1000000 = 1.0
    from_high: f32,
    /// What the start becomes. -1000000..1000000 = 0.0
    to_low: f32,
    /// What the end becomes. -1000000..1000000 = 1.0
    to_high: f32,
) -> f32 {
    let carried = mix(to_low, to_high, ramp(x, from_low, from_high));
    return clamp(carried, min(to_low, to_high), max(to_low, to_high));
}
