//! How much of the upper of two materials shows: each counts by its height times its weight, so stones stand out of the sand.
//! The weights never sum to 0 (see `layer_max_weight`), and a material of weight 0 stays away.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro, 2010, listing 1.6; his epsilon stands with the heights, where it keeps the sum at 1.

/// height_blend(0.5, 0.5, 0.25) == 0.25 +- 1e-6
/// height_blend(0.2, 0.8, 0.5) == 0.7988327 +- 1e-5
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
    let below = layer_max_weight(layer_max_score(1.0 - amount, bottom));
    let above = layer_max_weight(layer_max_score(amount, top));
    return saturate(above / max(below + above, 1e-6));
}
