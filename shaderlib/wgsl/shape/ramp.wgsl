//! A straight rise from 0 to 1 between two values; it falls where `low` is the higher one, and steps where both are equal.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, section 5.2.3.

/// ramp(0.3, 0.2, 0.6) == 0.25 +- 1e-6
/// ramp(0.4, 0.5, 0.35) == 0.6666667 +- 1e-6
/// ramp(800.0, 900.0, 700.0) == 0.5 +- 1e-6
/// ramp(2.0, 2.0, 2.0) == 1.0 +- 0
/// ramp(1.9, 2.0, 2.0) == 0.0 +- 0
/// -> 0 at low and before, 1 at high and beyond. 0..1
fn ramp(
    /// The value that decides. -1000000..1000000
    x: f32,
    /// Where it is still 0. -1000000..1000000 = 0.0
    low: f32,
    /// Where it is 1. -1000000..1000000 = 1.0
    high: f32,
) -> f32 {
    let way = select(high - low, low - high, high < low);
    let gone = select(x - low, low - x, high < low);
    // Held inside the ramp before the division: equal and nearly equal ends give a clean step, never an overflow.
    let inside = clamp(gone, 0.0, way) / max(way, 1.2e-38);
    return select(saturate(inside), 1.0, gone >= way);
}
