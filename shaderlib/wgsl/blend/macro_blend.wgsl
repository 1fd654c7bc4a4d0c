//! Brightens and darkens a tiled colour over large distances, so that its repetition no longer shows.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, section 5.1 (low-frequency variation over tiled detail maps).

/// macro_blend(vec3f(0.4, 0.2, 0.1), 0.5, 0.6) == vec3f(0.4, 0.2, 0.1) +- 1e-6
/// macro_blend(vec3f(0.4, 0.2, 0.1), 1.0, 0.5) == vec3f(0.6, 0.3, 0.15) +- 1e-6
/// macro_blend(vec3f(0.4, 0.2, 0.1), 0.0, 0.5) == vec3f(0.2, 0.1, 0.05) +- 1e-6
/// -> The varied colour. 0..1
fn macro_blend(
    /// The tiled colour. 0..1
    base: vec3f,
    /// The large variation around 0.5, such as `fbm`. 0..1
    variation: f32,
    /// How much brighter and darker it gets. 0..1 = 0.3
    amount: f32,
) -> vec3f {
    return saturate(base * mix(1.0, 2.0 * variation, amount));
}
