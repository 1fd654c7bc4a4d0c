//! Light that a perfectly matt surface throws back, the same in every direction.
//! Source: Lambert, "Photometria", 1760; Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th edition, 2023, section 9.2.

/// lambert(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.6, 0.8)) == 0.1909859 +- 1e-5
/// lambert(vec3f(0.0, 1.0, 0.0), vec3f(0.0, -0.6, 0.8)) == 0.0 +- 0
/// -> Cosine over pi: times albedo and irradiance it is radiance. 0..0.3183099
fn lambert(
    /// Of the surface, unit length. -1..1
    normal: vec3f,
    /// Unit vector to the light. -1..1
    light: vec3f,
) -> f32 {
    return 0.3183098 * saturate(dot(normal, light));
}
