//! What a surface mirrors straight on: 4 % for stone, soil and plants, its own colour for metal.
//! Source: Burley, "Physically-Based Shading at Disney", SIGGRAPH 2012 course (metallic workflow).

/// f0_from_metallic(vec3f(0.8, 0.6, 0.2), 0.0) == vec3f(0.04, 0.04, 0.04) +- 1e-6
/// f0_from_metallic(vec3f(0.8, 0.6, 0.2), 0.5) == vec3f(0.42, 0.32, 0.12) +- 1e-6
/// -> Linear Rec. 709. 0..1
fn f0_from_metallic(
    /// The surface's colour. 0..1
    albedo: vec3f,
    /// 0 for everything but bare metal. 0..1 = 0.0
    metallic: f32,
) -> vec3f {
    return saturate(mix(vec3f(0.04), albedo, metallic));
}
