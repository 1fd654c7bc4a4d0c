//! Photoshop's "Soft Light": like `overlay`, gentler, a diffuse lamp.
//! Source: W3C, "Compositing and Blending Level 1", 2015, section 10.1.10 (soft-light).

/// soft_light_f32(0.5, 0.25, 1.0) == 0.375 +- 1e-6
/// soft_light_f32(0.64, 1.0, 1.0) == 0.8 +- 1e-6
/// soft_light_f32(0.1, 0.75, 1.0) == 0.198 +- 1e-6
/// -> The combined mask. 0..1
fn soft_light_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    let low = ((16.0 * base - 12.0) * base + 4.0) * base;
    let bright = select(sqrt(max(base, 0.25)), low, base <= 0.25);
    let darker = base - (1.0 - 2.0 * detail) * base * (1.0 - base);
    let lighter = base + (2.0 * detail - 1.0) * (bright - base);
    return saturate(mix(base, select(lighter, darker, detail <= 0.5), opacity));
}

/// soft_light_vec3(vec3f(0.5, 0.64, 0.1), vec3f(0.25, 1.0, 0.75), 1.0) == vec3f(0.375, 0.8, 0.198) +- 1e-6
/// -> The combined colour. 0..1
fn soft_light_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    let low = ((16.0 * base - 12.0) * base + 4.0) * base;
    let bright = select(sqrt(max(base, vec3f(0.25))), low, base <= vec3f(0.25));
    let darker = base - (1.0 - 2.0 * detail) * base * (1.0 - base);
    let lighter = base + (2.0 * detail - 1.0) * (bright - base);
    return saturate(mix(base, select(lighter, darker, detail <= vec3f(0.5)), opacity));
}
