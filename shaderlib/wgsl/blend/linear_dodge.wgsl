//! Photoshop's "Linear Dodge (Add)": the sum of both, held at 1.
//! Source: Adobe, Photoshop "Blending mode descriptions" (Linear Dodge).

/// linear_dodge_f32(0.25, 0.5, 1.0) == 0.75 +- 1e-6
/// linear_dodge_f32(0.75, 0.5, 1.0) == 1.0 +- 1e-6
/// linear_dodge_f32(0.2, 0.4, 0.5) == 0.4 +- 1e-6
/// -> The combined mask. 0..1
fn linear_dodge_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    return saturate(mix(base, min(base + detail, 1.0), opacity));
}

/// linear_dodge_vec3(vec3f(0.25, 0.75, 0.2), vec3f(0.5, 0.5, 0.4), 1.0) == vec3f(0.75, 1.0, 0.6) +- 1e-6
/// -> The combined colour. 0..1
fn linear_dodge_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    return saturate(mix(base, min(base + detail, vec3f(1.0)), opacity));
}
