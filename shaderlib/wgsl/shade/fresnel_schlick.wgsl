//! How much more a surface mirrors the flatter one looks at it.
//! Source: Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994, equation 15.

/// fresnel_schlick(vec3f(0.04, 0.04, 0.5), 1.0) == vec3f(0.04, 0.04, 0.5) +- 1e-6
/// fresnel_schlick(vec3f(0.04, 0.04, 0.5), 0.5) == vec3f(0.07, 0.07, 0.515625) +- 1e-6
/// fresnel_schlick(vec3f(0.04, 0.04, 0.5), 0.0) == vec3f(1.0, 1.0, 1.0) +- 1e-6
/// -> 1 at grazing angles. 0..1
fn fresnel_schlick(
    /// What is mirrored when looking straight at the surface. 0..1 = (0.04, 0.04, 0.04)
    f0: vec3f,
    /// Cosine of the angle between view and half vector. -1..1
    facing: f32,
) -> vec3f {
    // Rounded unit vectors give cosines just above 1; saturated first, so nothing negative is raised to a power.
    let m = 1.0 - saturate(facing);
    let m2 = m * m;
    return saturate(mix(f0, vec3f(1.0), m2 * m2 * m));
}
