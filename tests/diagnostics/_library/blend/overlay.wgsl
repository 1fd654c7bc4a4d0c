//! Adds detail to a mask and keeps it where it is 0 or 1.
//! Source: test.

/// overlay(0.0, 0.5, 1.0) == 0.0 +- 0.0
/// -> The combined mask. 0..1
fn overlay(
    /// The mask that keeps its shape. 0..1
    base: f32,
    /// The detail to add. 0..1
    detail: f32,
    /// How much of it. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    return mix(base, 2.0 * base * detail, opacity * (1.0 - base));
}
