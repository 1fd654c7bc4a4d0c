//! The lower of two values with the crease between them rounded.
//! Source: Quilez, "Smooth Minimum", 2013 (quadratic polynomial).

/// soft_lowest(1.0, 3.0, 0.5) == 1.0 +- 1e-6
/// soft_lowest(0.5, 0.5, 0.4) == 0.4 +- 1e-6
/// soft_lowest(0.2, 0.4, 0.4) == 0.175 +- 1e-6
/// -> At most a quarter of the softness under the lower one. -1000300..1000000
fn soft_lowest(
    /// One value. -1000000..1000000
    a: f32,
    /// The other one. -1000000..1000000
    b: f32,
    /// From which difference on the crease is rounded. 0..1000 = 0.1
    softness: f32,
) -> f32 {
    let width = max(softness, 1e-6);
    let near = max(width - abs(a - b), 0.0) / width;
    return min(a, b) - 0.25 * near * near * width;
}
