//! 1 between two values, 0 outside, with soft borders on either side.
//! Source: Terrane; the product of two eased ramps.

/// between(5.0, 2.0, 8.0, 2.0) == 1.0 +- 1e-6
/// between(2.0, 2.0, 8.0, 2.0) == 0.5 +- 1e-6
/// between(8.5, 2.0, 8.0, 2.0) == 0.15625 +- 1e-6
/// between(9.0, 2.0, 8.0, 0.0) == 0.0 +- 0
/// -> Half way on either border. 0..1
fn between(
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
    let above = ramp_smooth(x, low - reach, low + reach);
    return saturate(above * (1.0 - ramp_smooth(x, high - reach, high + reach)));
}
