//! Steepens or flattens the middle and leaves 0, 0.5 and 1 where they are: contrast without clipping.
//! Source: Schlick, "Fast Alternatives to Perlin's Bias and Gain Functions", Graphics Gems IV, 1994.

/// gain(0.25, 0.25) == 0.125 +- 1e-6
/// gain(0.75, 0.25) == 0.875 +- 1e-6
/// gain(0.5, 0.9) == 0.5 +- 1e-6
/// gain(0.3, 0.5) == 0.3 +- 1e-6
/// -> The bent value. 0..1
fn gain(
    /// The value to bend. 0..1
    x: f32,
    /// 0.5 changes nothing, less is steeper in the middle, more is flatter. 0.01..0.99 = 0.5
    amount: f32,
) -> f32 {
    let lower = x < 0.5;
    let y = select(2.0 - 2.0 * x, 2.0 * x, lower);
    let bent = 0.5 * bias(y, amount);
    return saturate(select(1.0 - bent, bent, lower));
}
