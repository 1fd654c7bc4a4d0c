//! What a rough surface mirrors of an even sky: Fresnel and shadowing, integrated over all directions.
//! Source: Karis, "Physically Based Shading on Mobile", 2014 (analytic fit of the split-sum integral).

/// env_brdf(vec3f(0.04, 0.04, 0.04), 1.0, 0.0) == vec3f(0.0456380, 0.0456380, 0.0456380) +- 1e-3
/// env_brdf(vec3f(1.0, 1.0, 1.0), 0.5, 0.5) == vec3f(0.7250000, 0.7250000, 0.7250000) +- 1e-3
/// -> Share of the sky's light. 0..1
fn env_brdf(
    /// What is mirrored when looking straight at the surface. 0..1 = (0.04, 0.04, 0.04)
    f0: vec3f,
    /// Cosine between normal and view. -1..1
    facing: f32,
    /// Perceptual roughness. 0..1 = 0.5
    roughness: f32,
) -> vec3f {
    let r = roughness * vec4f(-1.0, -0.0275, -0.572, 0.022) + vec4f(1.0, 0.0425, 1.04, -0.04);
    let grazing = min(r.x * r.x, exp2(-9.28 * saturate(facing))) * r.x + r.y;
    let fit = vec2f(-1.04, 1.04) * grazing + r.zw;
    return saturate(f0 * fit.x + fit.y);
}
