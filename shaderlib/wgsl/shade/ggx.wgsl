//! The share of a rough surface's facets that mirror light from one direction into another (Trowbridge-Reitz, "GGX").
//! Source: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, equation 33; roughness squared after Burley, "Physically-Based Shading at Disney", 2012.

/// ggx(1.0, 1.0) == 0.3183099 +- 1e-5
/// ggx(1.0, 0.5) == 5.092958 +- 1e-3
/// ggx(0.8, 0.5) == 0.1243398 +- 1e-4
/// -> Facets per solid angle. [1/sr] 0..80000
fn ggx(
    /// Cosine between the normal and the half vector. -1..1
    facing: f32,
    /// Perceptual roughness; values under 0.045 count as 0.045. 0..1 = 0.5
    roughness: f32,
) -> f32 {
    let a = ggx_alpha(roughness);
    let c = saturate(facing);
    // 1 - c^2 (1 - a^2) as a sum of squares of positive terms: it never cancels to 0.
    let d = (1.0 - c) * (1.0 + c) + c * c * a * a;
    return 0.3183099 * (a / d) * (a / d);
}

/// Facet slope from perceptual roughness. The floor of 0.045 is Filament's for f32: smoother highlights flicker.
fn ggx_alpha(roughness: f32) -> f32 {
    let r = clamp(roughness, 0.045, 1.0);
    return r * r;
}
