//! What a clear surface mirrors straight on, from its index of refraction: 1.33 for water, 1.31 for ice, 1.5 for quartz.
//! Source: Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th edition, 2023, section 9.3 (Fresnel equations at normal incidence).

/// f0_from_ior(1.5) == 0.04 +- 1e-6
/// f0_from_ior(1.333) == 0.02037319 +- 1e-6
/// f0_from_ior(1.0) == 0.0 +- 0
/// -> For `fresnel_schlick`. 0..1
fn f0_from_ior(
    /// Index of refraction. 1..4 = 1.5
    ior: f32,
) -> f32 {
    let r = (ior - 1.0) / (ior + 1.0);
    return saturate(r * r);
}
