//! Light that a rough matt surface throws back: flatter than Lambert, as dry soil, sand and rock are.
//! Source: Fujii, "A tiny improvement of Oren-Nayar reflectance model", 2012 (the qualitative model, continuous everywhere).

/// oren_nayar(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.6, 0.8), vec3f(0.0, 1.0, 0.0), 0.0) == 0.1909859 +- 1e-5
/// oren_nayar(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.6, 0.8), 1.0) == 0.2471747 +- 1e-5
/// oren_nayar(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.6, 0.8), vec3f(0.0, 0.6, 0.8), 1.0) == 0.3064966 +- 1e-5
/// -> Reflectance times cosine: times albedo and irradiance it is radiance. 0..0.5
fn oren_nayar(
    /// Of the surface, unit length. -1..1
    normal: vec3f,
    /// Unit vector to the light. -1..1
    light: vec3f,
    /// Unit vector to the eye. -1..1
    view: vec3f,
    /// How rough: 0 is Lambert, 1 is dust. 0..1 = 0.5
    sigma: f32,
) -> f32 {
    let nl = saturate(dot(normal, light));
    let nv = saturate(dot(normal, view));
    let s = clamp(dot(light, view), -1.0, 1.0) - nl * nv;
    let a = 1.0 / (3.1415927 + 0.90412966 * sigma);
    // n.l / t is at most 1 where t = max(n.l, n.v): kept together, nothing grows at grazing angles.
    let t = select(1.0, max(max(nl, nv), 1e-6), s > 0.0);
    return clamp(a * (nl + sigma * s * (nl / t)), 0.0, 0.5);
}
