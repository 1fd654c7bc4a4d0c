//! Photoshop's "Levels": black point, white point and gamma in one.
//! Source: Adobe, Photoshop "Levels adjustment" (input levels and gamma).

/// levels(0.5, 0.2, 0.8, 1.0) == 0.5 +- 1e-6
/// levels(0.5, 0.0, 1.0, 2.0) == 0.70710678 +- 1e-5
/// levels(0.1, 0.2, 0.8, 2.0) == 0.0 +- 0
/// -> 0 at black, 1 at white. 0..1
fn levels(
    /// The value to correct. 0..1
    x: f32,
    /// What becomes 0. 0..1 = 0.0
    black: f32,
    /// What becomes 1. 0..1 = 1.0
    white: f32,
    /// More than 1 brightens the middle. 0.1..10 = 1.0
    gamma: f32,
) -> f32 {
    let t = ramp(x, black, white);
    let bent = pow(max(t, 1e-20), 1.0 / max(gamma, 0.1));
    return select(saturate(bent), 0.0, t <= 0.0);
}
