//! Photoshop's "Subtract": what remains of the base, held at 0.
//! Source: Adobe, Photoshop "Blending mode descriptions" (Subtract).

/// subtract_f32(0.75, 0.25, 1.0) == 0.5 +- 1e-6
/// subtract_f32(0.25, 0.5, 1.0) == 0.0 +- 1e-6
/// subtract_f32(0.5, 0.5, 0.5) == 0.25 +- 1e-6
/// -> The combined mask. 0..1
fn subtract_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    return saturate(mix(base, max(base - detail, 0.0), opacity));
}

/// subtract_vec3(vec3f(0.75, 0.25, 0.5), vec3f(0.25, 0.5, 0.5), 1.0) == vec3f(0.5, 0.0, 0.0) +- 1e-6
/// -> The combined colour. 0..1
fn subtract_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    return saturate(mix(base, max(base - detail, vec3f(0.0)), opacity));
}
