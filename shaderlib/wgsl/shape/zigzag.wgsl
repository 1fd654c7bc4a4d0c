//! A triangle wave between 0 and 1.
//! Source: Ebert et al., "Texturing and Modeling: A Procedural Approach", 3rd edition, 2003, chapter 2 (building blocks).

/// zigzag(0.0, 4.0) == 0.0 +- 1e-6
/// zigzag(1.0, 4.0) == 0.5 +- 1e-6
/// zigzag(-2.0, 4.0) == 1.0 +- 1e-6
/// zigzag(7.0, 4.0) == 0.5 +- 1e-5
/// -> 0 at 0, rising. 0..1
fn zigzag(
    /// Along the wave. -1000000..1000000
    x: f32,
    /// From valley to valley. 0.001..1000000 = 1.0
    period: f32,
) -> f32 {
    let turns = x / max(period, 0.001);
    return saturate(1.0 - abs(2.0 * (turns - floor(turns)) - 1.0));
}
