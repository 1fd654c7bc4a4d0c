//! How much of the upper of two materials shows where everything within a band under the highest takes part.
//! The weights never sum to 0 and every step is continuous: the proof stands with `layer_soft_weight`.
//! Source: Mishkinis, "Advanced Terrain Texture Splatting", Gamasutra, 2013 (weights from a band under the highest); with weights as factors so that 0 stays 0.

/// height_soft(0.5, 0.5, 0.5, 0.2) == 0.5 +- 1e-6
/// height_soft(0.0, 1.0, 0.5, 0.2) == 1.0 +- 1e-6
/// height_soft(0.5, 0.6, 0.5, 0.2) == 0.5714286 +- 1e-5
/// height_soft(1.0, 1.0, 0.0, 0.2) == 0.0 +- 0
/// -> Share of the upper material, for `lerp`. 0..1
fn height_soft(
    /// Height of the lower material. 0..1
    bottom: f32,
    /// Height of the upper material. 0..1
    top: f32,
    /// Weight of the upper material. 0..1 = 0.5
    amount: f32,
    /// How far under the highest a material still shows. 0.001..1 = 0.15
    band: f32,
) -> f32 {
    let below = layer_soft_score(1.0 - amount, bottom);
    let above = layer_soft_score(amount, top);
    let highest = max(below, above);
    let low = layer_soft_weight(1.0 - amount, below, highest, band);
    let high = layer_soft_weight(amount, above, highest, band);
    return saturate(high / max(low + high, 1e-6));
}
