//! The higher of two values with the crease between them rounded.
//! Source: Quilez, "Smooth Minimum", 2013 (quadratic polynomial), upside down.

/// soft_highest(1.0, 3.0, 0.5) == 3.0 +- 1e-6
/// soft_highest(0.5, 0.5, 0.4) == 0.6 +- 1e-6
/// soft_highest(0.2, 0.4, 0.4) == 0.425 +- 1e-6
/// -> At most a quarter of the softness above the higher one. -1000000..1000300
fn soft_highest(
    /// One value. -1000000..1000000
    a: f32,
    /// The other one. -1000000..1000000
    b: f32,
    /// From which difference on the crease is rounded. 0..1000 = 0.1
    softness: f32,
) -> f32 {
    return -soft_lowest(-a, -b, softness);
}
