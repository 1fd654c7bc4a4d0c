//! Photoshop's "Overlay": adds detail to a mask or colour and keeps it where it is 0 or 1.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, listing 2 (overlayBlend).

/// overlay_f32(0.25, 0.5, 1.0) == 0.25 +- 1e-6
/// overlay_f32(0.25, 1.0, 1.0) == 0.5 +- 1e-6
/// overlay_f32(0.8, 0.25, 0.5) == 0.75 +- 1e-6
/// -> The combined mask. 0..1
fn overlay_f32(
    /// The mask that keeps its shape. 0..1
    base: f32,
    /// The detail to add. 0..1
    detail: f32,
    /// How much of it. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    let dark = 2.0 * base * detail;
    let light = 1.0 - 2.0 * (1.0 - base) * (1.0 - detail);
    return saturate(mix(base, select(light, dark, base < 0.5), opacity));
}

/// overlay_vec3(vec3f(0.25, 0.25, 0.8), vec3f(0.5, 1.0, 0.25), 1.0) == vec3f(0.25, 0.5, 0.7) +- 1e-6
/// -> The combined colour. 0..1
fn overlay_vec3(
    /// The colour that keeps its shape. 0..1
    base: vec3f,
    /// The detail to add. 0..1
    detail: vec3f,
    /// How much of it. 0..1 = 1.0
    opacity: f32,
) -> vec3f {
    let dark = 2.0 * base * detail;
    let light = 1.0 - 2.0 * (1.0 - base) * (1.0 - detail);
    return saturate(mix(base, select(light, dark, base < vec3f(0.5)), opacity));
}
