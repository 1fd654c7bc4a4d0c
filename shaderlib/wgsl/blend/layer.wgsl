//! What the generator calls to composite any number of layers; not a node.
//!
//! A layer's share is the part of the ground that its mask leaves to it, from the top layer down: shares are in 0..1 and
//! add up to 1. A score says how far a layer stands out; a layer that was not weighed scores LAYER_ABSENT and gets no weight.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro 1, 2010, section 1.7.3, listings 1.6 and 1.7;
//! the soft band after Mishkinis, "Advanced Terrain Texture Splatting", 2013, with shares that vanish continuously.

/// Below every score, by more than any band.
const LAYER_ABSENT: f32 = -2.0;

/// Keeps layers apart that all lie at height 0: half a step of an 8-bit height.
const LAYER_GROUND: f32 = 0.001953125;

/// Score under `height_max`: Drobot's weighted height, h w. In 0..1.002.
fn layer_max_score(share: f32, height: f32) -> f32 {
    return share * (saturate(height) + LAYER_GROUND);
}

/// Weight under `height_max`, before normalisation: listing 1.6. The largest share is at least 1/n, so that the sum of n
/// weights is at least LAYER_GROUND / n, never 0.
fn layer_max_weight(score: f32) -> f32 {
    return max(score, 0.0);
}

/// Score under `height_soft`: w (1 + h), so that a share of 0 stands nowhere. In 0..2.
fn layer_soft_score(share: f32, height: f32) -> f32 {
    return share * (1.0 + saturate(height));
}

/// Weight under `height_soft`, before normalisation: how far the score reaches into the band under the highest, times the share.
///
/// The largest share is at least 1/n, so the highest score m is at least 1/n; a layer that scores m has a share of at least
/// m/2 ≥ 1/(2n) and the weight band · share. The sum of the weights is therefore at least band / (2n), never 0; every weight
/// is continuous in share and height, and 0 where the share is 0.
fn layer_soft_weight(share: f32, score: f32, highest: f32, band: f32) -> f32 {
    return max(score - highest + band, 0.0) * share;
}

/// The slopes that a tangent-space normal stands for: what adds up when height fields are blended (partial derivatives).
fn layer_slopes(normal: vec3f) -> vec2f {
    return normal.xy / max(normal.z, 0.001);
}

/// The tangent-space normal of slopes.
fn layer_normal(slopes: vec2f) -> vec3f {
    return normalize(vec3f(slopes, 1.0));
}
