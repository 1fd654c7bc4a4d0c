//! Spreads values around the middle: turns a soft grey texture into a crisp mask.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, listing 2 (scaleContrast).

/// contrast(0.6, 2.0) == 0.7 +- 1e-6
/// contrast(0.1, 4.0) == 0.0 +- 0
/// -> 0.5 stays 0.5. 0..1
fn contrast(
    /// The value to spread. 0..1
    x: f32,
    /// 1 changes nothing, 0 makes everything grey, more is crisper. 0..64 = 2.0
    amount: f32,
) -> f32 {
    return saturate((x - 0.5) * amount + 0.5);
}
