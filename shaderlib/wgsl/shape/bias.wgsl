//! Pulls middle values up or down and leaves 0 and 1 where they are.
//! Source: Schlick, "Fast Alternatives to Perlin's Bias and Gain Functions", Graphics Gems IV, 1994.

/// bias(0.5, 0.25) == 0.25 +- 1e-6
/// bias(0.25, 0.8) == 0.5714286 +- 1e-6
/// bias(1.0, 0.3) == 1.0 +- 1e-6
/// -> The bent value. 0..1
fn bias(
    /// The value to bend. 0..1
    x: f32,
    /// What 0.5 becomes. 0.01..0.99 = 0.5
    amount: f32,
) -> f32 {
    return saturate(x * amount / ((1.0 - 2.0 * amount) * (1.0 - x) + amount));
}
