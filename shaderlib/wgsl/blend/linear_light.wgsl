//! Photoshop's "Linear Light": burns where the detail is under 0.5 and dodges where it is above; grey changes nothing.
//! Source: Adobe, Photoshop "Blending mode descriptions" (Linear Light: base + 2 blend - 1).

/// linear_light_f32(0.5, 0.6, 1.0) == 0.7 +- 1e-6
/// linear_light_f32(0.25, 0.25, 1.0) == 0.0 +- 1e-6
/// linear_light_f32(0.75, 0.75, 1.0) == 1.0 +- 1e-6
/// -> The combined mask. 0..1
fn linear_light_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    return saturate(mix(base, saturate(base + 2.0 * detail - 1.0), opacity));
}

/// linear_light_vec3(vec3f(0.5, 0.25, 0.75), vec3f(0.6, 0.25, 0.75), 1.0) == vec3f(0.7, 0.0, 1.0) +- 1e-6
/// -> The combined colour. 0..1
fn linear_light_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    return saturate(mix(base, saturate(base + 2.0 * detail - 1.0), opacity));
}
