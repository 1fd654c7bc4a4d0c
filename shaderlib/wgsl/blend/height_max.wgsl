//! Which of two materials is on top: the one whose height times weight is larger, and no mixture.
//! Layers: score (h + 1/4096) w, weight 1 for the highest score and 0 for others, equal scores share. Where the w sum to 1 one
//! of n is at least 1/n, so the highest score is at least 1/(4096 n) > 0: a layer of weight 0 never wins, and since the
//! highest score is one of the scores, the total weight is at least 1.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro, 2010, section 1.7.3 and listing 1.7; the 1/4096 decides where all heights are 0.

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
    let below = height_max_score(bottom, 1.0 - amount);
    let above = height_max_score(top, amount);
    let highest = max(below, above);
    let share = height_max_weight(above, highest);
    return share / (share + height_max_weight(below, highest));
}

/// What one of several layers is ranked by. Height and weight 0..1.
fn height_max_score(height: f32, weight: f32) -> f32 {
    return (height + HEIGHT_BLEND_FLOOR) * weight;
}

/// Weight of a layer, to be divided by the sum of all: `highest` is the largest score.
fn height_max_weight(score: f32, highest: f32) -> f32 {
    return select(0.0, 1.0, score >= highest);
}
