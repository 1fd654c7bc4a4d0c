//! Photoshop's "Color Dodge": brightens the base by dividing it by the inverse of the detail.
//! Source: W3C, "Compositing and Blending Level 1", 2015, section 10.1.7 (color-dodge).

/// color_dodge_f32(0.25, 0.5, 1.0) == 0.5 +- 1e-6
/// color_dodge_f32(0.5, 0.75, 1.0) == 1.0 +- 1e-6
/// color_dodge_f32(0.0, 1.0, 1.0) == 0.0 +- 1e-6
/// -> The combined mask. 0..1
fn color_dodge_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    let room = 1.0 - detail;
    // Divided only where the quotient is at most 1.
    let quotient = min(base, room) / max(room, 1e-7);
    let dodged = select(quotient, 1.0, base >= room);
    return saturate(mix(base, select(dodged, 0.0, base <= 0.0), opacity));
}

/// color_dodge_vec3(vec3f(0.25, 0.5, 0.0), vec3f(0.5, 0.75, 1.0), 1.0) == vec3f(0.5, 1.0, 0.0) +- 1e-6
/// -> The combined colour. 0..1
fn color_dodge_vec3(
    /// What lies below. 0..1
    base: vec3f,
    /// What is laid on it. 0..1
    detail: vec3f,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    let room = 1.0 - detail;
    // Divided only where the quotient is at most 1.
    let quotient = min(base, room) / max(room, vec3f(1e-7));
    let dodged = select(quotient, vec3f(1.0), base >= room);
    return saturate(mix(base, select(dodged, vec3f(0.0), base <= vec3f(0.0)), opacity));
}
