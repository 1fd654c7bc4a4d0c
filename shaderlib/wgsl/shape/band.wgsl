//! 1 between two values, 0 outside, with soft borders on either side.
//! Source: Terrane; the product of two eased ramps.

/// band(5.0, 2.0, 8.0, 2.0) == 1.0 +- 1e-6
/// band(2.0, 2.0, 8.0, 2.0) == 0.5 +- 1e-6
/// band(8.5, 2.0, 8.0, 2.0) == 0.15625 +- 1e-6
/// band(9.0, 2.0, 8.0, 0.0) == 0.0 +- 0
/// -> Half way on either border. 0..1
fn band(
    /// The value that decides. -1000000..1000000
    x: f32,
    /// Lower border. -1000000..1000000 = 0.0
    low: f32,
    /// Upper border. -1000000..1000000 = 1.0
    high: f32,
    /// Width of a border, half of it outside. 0..1000000 = 0.1
    softness: f32,
) -> f32 {
    let reach = 0.5 * softness;
    return saturate(ramp_smooth(x, low - reach, low + reach) * ramp_smooth(x, high + reach, high - reach));
}
