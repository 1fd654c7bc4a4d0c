//! Keeps the lighter of both.
//! Source: W3C, "Compositing and Blending Level 1", 2015, section 10.1.6 (lighten).

/// lighten_f32(0.5, 0.25, 1.0) == 0.5 +- 1e-6
/// lighten_f32(0.2, 0.6, 1.0) == 0.6 +- 1e-6
/// lighten_f32(0.4, 0.8, 0.5) == 0.6 +- 1e-6
/// -> The combined mask. 0..1
fn lighten_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    return saturate(mix(base, max(base, detail), opacity));
}

/// lighten_vec3(vec3f(0.5, 0.2, 0.4), vec3f(0.25, 0.6, 0.8), 1.0) == vec3f(0.5, 0.6, 0.8) +- 1e-6
/// -> The combined colour. 0..1
fn lighten_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    return saturate(mix(base, max(base, detail), opacity));
}
