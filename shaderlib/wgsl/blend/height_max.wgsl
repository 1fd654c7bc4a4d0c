//! Which of two materials is on top: the one whose height times weight is larger, and no mixture.
//! Equal scores share. The score (h + 1/512) w of one of both is at least 1/1024, so a material of weight 0 never wins.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro, 2010, section 1.7.3 and listing 1.7; the 1/512 decides where all heights are 0.

/// height_max(0.5, 0.6, 0.5) == 1.0 +- 0
/// height_max(0.9, 0.6, 0.5) == 0.0 +- 0
/// height_max(0.0, 1.0, 0.0) == 0.0 +- 0
/// height_max(0.0, 0.0, 0.6) == 1.0 +- 0
/// height_max(0.5, 0.5, 0.5) == 0.5 +- 0
/// -> Share of the upper material, for `lerp`. 0..1
fn height_max(
    /// Height of the lower material. 0..1
    bottom: f32,
    /// Height of the upper material. 0..1
    top: f32,
    /// Weight of the upper material. 0..1 = 0.5
    amount: f32,
) -> f32 {
    let below = layer_max_score(1.0 - amount, bottom);
    let above = layer_max_score(amount, top);
    return select(select(0.0, 1.0, above > below), 0.5, above == below);
}
