//! Where the ground faces the sun of the scene.
//! Source: Lambert, "Photometria", 1760 (cosine law); the wrap is Valve's half Lambert, Mitchell, McTaggart and Green, "Shading in Valve's Source Engine", 2006, generalised.

/// sun_mask(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.6, 0.8), 0.0) == 0.6 +- 1e-6
/// sun_mask(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.6, 0.8), 1.0) == 0.8 +- 1e-6
/// sun_mask(vec3f(0.0, 1.0, 0.0), vec3f(0.0, -0.6, 0.8), 0.0) == 0.0 +- 0
/// -> 1 where it faces the sun. 0..1
fn sun_mask(
    /// The ground's, in world space, y up. -1..1
    normal: vec3f,
    /// Unit vector to the sun. -1..1
    sun: vec3f,
    /// How far the mask reaches around to the shaded side. 0..1 = 0.0
    wrap: f32,
) -> f32 {
    return saturate((dot(normal, sun) + wrap) / (1.0 + wrap));
}
