//! Photoshop's "Color Burn": darkens the base by dividing its inverse by the detail.
//! Source: W3C, "Compositing and Blending Level 1", 2015, section 10.1.8 (color-burn).

/// color_burn_f32(0.75, 0.5, 1.0) == 0.5 +- 1e-6
/// color_burn_f32(0.5, 0.25, 1.0) == 0.0 +- 1e-6
/// color_burn_f32(1.0, 0.0, 1.0) == 1.0 +- 1e-6
/// -> The combined mask. 0..1
fn color_burn_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    let lack = 1.0 - base;
    // Divided only where the quotient is at most 1.
    let quotient = min(lack, detail) / max(detail, 1e-7);
    let burnt = 1.0 - select(quotient, 1.0, lack >= detail);
    return saturate(mix(base, select(burnt, 1.0, base >= 1.0), opacity));
}

/// color_burn_vec3(vec3f(0.75, 0.5, 1.0), vec3f(0.5, 0.25, 0.0), 1.0) == vec3f(0.5, 0.0, 1.0) +- 1e-6
/// -> The combined colour. 0..1
fn color_burn_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    let lack = 1.0 - base;
    // Divided only where the quotient is at most 1.
    let quotient = min(lack, detail) / max(detail, vec3f(1e-7));
    let burnt = 1.0 - select(quotient, vec3f(1.0), lack >= detail);
    return saturate(mix(base, select(burnt, vec3f(1.0), base >= vec3f(1.0)), opacity));
}
