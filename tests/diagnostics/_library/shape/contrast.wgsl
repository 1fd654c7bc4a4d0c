//! Pulls values away from the middle.
//! Source: test.

/// contrast(0.5, 2.0) == 0.5 +- 0.0
/// -> The result. 0..1
fn contrast(
    /// What to change. 0..1
    x: f32,
    /// How much. 0..8 = 1.0
    amount: f32,
) -> f32 {
    return clamp((x - 0.5) * amount + 0.5, 0.0, 1.0);
}
