//! How much of the upper of two materials shows where everything within a band under the highest takes part.
//! Layers: score s = w (1 + h), weight b = max(s - highest + band, 0) w, divided by the sum. Contract: the w are 0..1 and sum
//! to 1 on entry. Then some w is at least 1/n, so the highest score is at least 1/n, and since h <= 1 its own w is at least
//! 1/(2n); its b is band w: the sum is at least band / (2n) > 0. A layer of weight 0 stays away; every step is continuous.
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
    reach: f32,
) -> f32 {
    let below = height_soft_score(bottom, 1.0 - amount);
    let above = height_soft_score(top, amount);
    let highest = max(below, above);
    let low = height_soft_weight(below, highest, reach, 1.0 - amount);
    let high = height_soft_weight(above, highest, reach, amount);
    return saturate(high / max(low + high, 1e-6));
}

/// What one of several layers is ranked by. Height and weight 0..1.
fn height_soft_score(height: f32, weight: f32) -> f32 {
    return weight * (1.0 + height);
}

/// Weight of a layer, to be divided by the sum of all: `highest` is the largest score, `reach` the band, 0.001..1.
fn height_soft_weight(score: f32, highest: f32, reach: f32, weight: f32) -> f32 {
    return max(score - highest + reach, 0.0) * weight;
}
