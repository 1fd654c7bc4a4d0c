//! Photoshop's "Multiply": darkens, as if both were slides one behind the other.
//! Source: W3C, "Compositing and Blending Level 1", 2015, section 10.1.2 (multiply).

/// multiply_f32(0.5, 0.5, 1.0) == 0.25 +- 1e-6
/// multiply_f32(0.8, 0.25, 0.5) == 0.5 +- 1e-6
/// multiply_f32(0.3, 1.0, 1.0) == 0.3 +- 1e-6
/// -> The combined mask. 0..1
fn multiply_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    return saturate(mix(base, base * detail, opacity));
}

/// multiply_vec3(vec3f(0.5, 0.8, 0.3), vec3f(0.5, 0.25, 1.0), 1.0) == vec3f(0.25, 0.2, 0.3) +- 1e-6
/// -> The combined colour. 0..1
fn multiply_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    return saturate(mix(base, base * detail, opacity));
}
