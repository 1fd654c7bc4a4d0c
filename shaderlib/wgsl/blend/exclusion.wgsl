//! Like `difference`, with less contrast: grey where both are grey.
//! Source: W3C, "Compositing and Blending Level 1", 2015, section 10.1.12 (exclusion).

/// exclusion_f32(0.5, 0.5, 1.0) == 0.5 +- 1e-6
/// exclusion_f32(1.0, 0.25, 1.0) == 0.75 +- 1e-6
/// exclusion_f32(0.2, 0.6, 1.0) == 0.56 +- 1e-6
/// -> The combined mask. 0..1
fn exclusion_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    return saturate(mix(base, base + detail - 2.0 * base * detail, opacity));
}

/// exclusion_vec3(vec3f(0.5, 1.0, 0.2), vec3f(0.5, 0.25, 0.6), 1.0) == vec3f(0.5, 0.75, 0.56) +- 1e-6
/// -> The combined colour. 0..1
fn exclusion_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    return saturate(mix(base, base + detail - 2.0 * base * detail, opacity));
}
