//! Facets hide and shadow each other on a rough surface: Smith's height-correlated term over 4 (n.l)(n.v).
//! Source: Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014, section 5.3; in the form of Lagarde and de Rousiers, "Moving Frostbite to PBR", 2014, listing 2.

/// smith_visibility(1.0, 1.0, 0.5) == 0.25 +- 1e-5
/// smith_visibility(0.5, 0.8, 1.0) == 0.3846154 +- 1e-5
/// -> Multiplies distribution and Fresnel. 0..50000
fn smith_visibility(
    /// Cosine between normal and light. -1..1
    light: f32,
    /// Cosine between normal and view. -1..1
    view: f32,
    /// Perceptual roughness; values under 0.045 count as 0.045. 0..1 = 0.5
    roughness: f32,
) -> f32 {
    let a2 = ggx_alpha(roughness) * ggx_alpha(roughness);
    let l = saturate(light);
    // Filament's floor: a pixel exactly edge-on must not divide by zero.
    let v = max(saturate(view), 1e-4);
    let hidden_light = v * sqrt(l * l * (1.0 - a2) + a2);
    let hidden_view = l * sqrt(v * v * (1.0 - a2) + a2);
    return 0.5 / max(hidden_light + hidden_view, 1e-5);
}
