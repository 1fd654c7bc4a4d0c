//! The highlight of a rough surface: GGX facets, Smith's height-correlated shadowing, Schlick's Fresnel.
//! Source: Cook and Torrance, "A Reflectance Model for Computer Graphics", 1982; terms as in Lagarde and de Rousiers, "Moving Frostbite to PBR", 2014, section 3.1.

/// cook_torrance(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.04, 0.04, 0.04), 1.0) == vec3f(0.0031831, 0.0031831, 0.0031831) +- 1e-6
/// cook_torrance(vec3f(0.0, 1.0, 0.0), vec3f(0.6, 0.8, 0.0), vec3f(-0.6, 0.8, 0.0), vec3f(0.5, 0.5, 0.5), 0.5) == vec3f(0.7823951, 0.7823951, 0.7823951) +- 1e-4
/// cook_torrance(vec3f(0.0, 1.0, 0.0), vec3f(0.6, -0.8, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(1.0, 1.0, 1.0), 0.5) == vec3f(0.0, 0.0, 0.0) +- 0
/// -> Reflectance times cosine: times irradiance it is radiance. 0..65504
fn cook_torrance(
    /// Of the surface, unit length. -1..1
    normal: vec3f,
    /// Unit vector to the light. -1..1
    light: vec3f,
    /// Unit vector to the eye. -1..1
    view: vec3f,
    /// What is mirrored when looking straight at the surface. 0..1 = (0.04, 0.04, 0.04)
    f0: vec3f,
    /// Perceptual roughness; values under 0.045 count as 0.045. 0..1 = 0.5
    roughness: f32,
) -> vec3f {
    let half_way = unit_vector_or(light + view, normal);
    let nl = saturate(dot(normal, light));
    let facets = ggx(dot(normal, half_way), roughness) * smith_visibility(nl, dot(normal, view), roughness);
    // The largest half float: brighter pixels would turn into infinities in a 16-bit image.
    return fresnel_schlick(f0, dot(view, half_way)) * min(facets * nl, 65504.0);
}
