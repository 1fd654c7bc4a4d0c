//! How much of the upper of two materials shows: each counts by its height times its weight, so stones stand out of the sand.
//! Layers: weights (h + 1/4096) w over their sum. Where the w sum to 1 the sum is at least 1/4096, so nothing is divided by 0;
//! a layer of weight 0 stays away.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro, 2010, listing 1.6; his epsilon stands with the heights, where it keeps the sum at 1.

/// height_blend(0.5, 0.5, 0.25) == 0.25 +- 1e-6
/// height_blend(0.2, 0.8, 0.5) == 0.8 +- 1e-3
/// height_blend(0.0, 0.0, 0.7) == 0.7 +- 1e-6
/// height_blend(0.9, 0.9, 0.0) == 0.0 +- 0
/// -> Share of the upper material, for `lerp`. 0..1
fn height_blend(
    /// Height of the lower material. 0..1
    bottom: f32,
    /// Height of the upper material. 0..1
    top: f32,
    /// Weight of the upper material. 0..1 = 0.5
    amount: f32,
) -> f32 {
    let below = height_blend_weight(bottom, 1.0 - amount);
    let above = height_blend_weight(top, amount);
    return saturate(above / max(below + above, 1e-6));
}

/// Weight of one of several layers, to be divided by the sum of all. Height and weight 0..1.
fn height_blend_weight(height: f32, weight: f32) -> f32 {
    return (height + HEIGHT_BLEND_FLOOR) * weight;
}

/// Less than a step of an 8-bit height: even ground of height 0 keeps its weights.
const HEIGHT_BLEND_FLOOR: f32 = 0.000244140625;
