//! Photoshop's "Hard Light": `overlay` with base and detail changed over, a harsh lamp.
//! Source: W3C, "Compositing and Blending Level 1", 2015, section 10.1.9 (hard-light).

/// hard_light_f32(0.5, 0.25, 1.0) == 0.25 +- 1e-6
/// hard_light_f32(0.25, 0.75, 1.0) == 0.625 +- 1e-6
/// hard_light_f32(0.8, 0.5, 1.0) == 0.8 +- 1e-6
/// -> The combined mask. 0..1
fn hard_light_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    let dark = 2.0 * base * detail;
    let light = 1.0 - 2.0 * (1.0 - base) * (1.0 - detail);
    return saturate(mix(base, select(light, dark, detail < 0.5), opacity));
}

/// hard_light_vec3(vec3f(0.5, 0.25, 0.8), vec3f(0.25, 0.75, 0.5), 1.0) == vec3f(0.25, 0.625, 0.8) +- 1e-6
/// -> The combined colour. 0..1
fn hard_light_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    let dark = 2.0 * base * detail;
    let light = 1.0 - 2.0 * (1.0 - base) * (1.0 - detail);
    return saturate(mix(base, select(light, dark, detail < vec3f(0.5)), opacity));
}
