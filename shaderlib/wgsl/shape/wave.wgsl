//! A sine wave between 0 and 1.
//! Source: Abramowitz and Stegun, "Handbook of Mathematical Functions", 1964, 4.3.

/// wave(0.0, 4.0) == 0.5 +- 1e-6
/// wave(1.0, 4.0) == 1.0 +- 1e-6
/// wave(11.0, 4.0) == 0.0 +- 1e-5
/// wave(1.0, 12.0) == 0.75 +- 1e-5
/// -> 0.5 at 0, rising. 0..1
fn wave(
    /// Along the wave. -1000000..1000000
    x: f32,
    /// From crest to crest. 0.001..1000000 = 1.0
    period: f32,
) -> f32 {
    let turns = x / max(period, 0.001);
    return saturate(0.5 + 0.5 * angle_unit(360.0 * (turns - floor(turns))).y);
}
