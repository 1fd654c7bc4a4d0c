//! Adds fine colour variation from a detail texture: mid-grey changes nothing, so the mean of the base stays.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, section 5.1 (detail maps over colour maps).

/// detail_blend(vec3f(0.4, 0.2, 0.1), vec3f(0.5, 0.5, 0.5), 1.0) == vec3f(0.4, 0.2, 0.1) +- 1e-6
/// detail_blend(vec3f(0.4, 0.2, 0.1), vec3f(0.75, 0.25, 1.0), 1.0) == vec3f(0.6, 0.1, 0.2) +- 1e-6
/// detail_blend(vec3f(0.4, 0.2, 0.1), vec3f(0.75, 0.25, 1.0), 0.5) == vec3f(0.5, 0.15, 0.15) +- 1e-6
/// -> The varied colour. 0..1
fn detail_blend(
    /// The colour at large. 0..1
    base: vec3f,
    /// The fine variation around 0.5. 0..1
    detail: vec3f,
    /// How much of it; a `footprint_mask` fades it out with distance. 0..1 = 1.0
    amount: f32,
) -> vec3f {
    return saturate(base * mix(vec3f(1.0), 2.0 * detail, amount));
}
