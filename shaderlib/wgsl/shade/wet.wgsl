//! Water on a material: porous ones get darker, all get smoother.
//! Source: Lagarde, "Water drop 3b - Physically based wet surfaces", 2013 (after Nakamae et al., 1990).

/// What water leaves of a material.
struct Wet {
    /// Darker where it soaks. 0..1
    albedo: vec3f,
    /// Smoother. 0..1
    roughness: f32,
}

/// wet(vec3f(0.5, 0.4, 0.3), 0.9, 0.0).albedo == vec3f(0.5, 0.4, 0.3) +- 1e-6
/// wet(vec3f(0.5, 0.4, 0.3), 0.9, 1.0).albedo == vec3f(0.1, 0.08, 0.06) +- 1e-5
/// wet(vec3f(0.5, 0.4, 0.3), 0.9, 1.0).roughness == 0.54 +- 1e-5
/// wet(vec3f(0.5, 0.4, 0.3), 0.5, 1.0).albedo == vec3f(0.5, 0.4, 0.3) +- 1e-5
fn wet(
    /// Of the dry material, linear Rec. 709. 0..1
    albedo: vec3f,
    /// Of the dry material; from 0.5 on it counts as porous, from 0.9 as sponge. 0..1 = 0.9
    roughness: f32,
    /// 0 is dry, 1 is soaked. 0..1 = 0.5
    amount: f32,
) -> Wet {
    let porous = saturate((roughness - 0.5) / 0.4);
    let factor = mix(1.0, 0.2, porous);
    let smoothed = mix(1.0, factor, 0.5 * amount);
    return Wet(saturate(albedo * mix(1.0, factor, amount)), saturate(roughness * smoothed));
}
