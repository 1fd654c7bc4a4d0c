//! A roughness made from the colour, so that it needs no texture: by default light parts are the smoother ones.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro, 2010, section 1.8.2 (generated roughness by inversion, power or scale).

/// roughness_from_color(vec3f(0.5, 0.5, 0.5), 1.0, 1.0, 0.4, 0.9) == 0.65 +- 1e-5
/// roughness_from_color(vec3f(0.2, 0.2, 0.2), 0.0, 2.0, 0.5, 1.0) == 0.52 +- 1e-5
/// -> Perceptual roughness. 0..1
fn roughness_from_color(
    /// Linear Rec. 709. 0..1
    color: vec3f,
    /// 1 makes dark parts the rougher ones, 0 the light ones. 0..1 = 1.0
    inversion: f32,
    /// More than 1 keeps roughness to the extreme parts. 0.1..16 = 1.0
    exponent: f32,
    /// Roughness of the smoothest parts. 0..1 = 0.5
    low: f32,
    /// Roughness of the roughest parts. 0..1 = 1.0
    high: f32,
) -> f32 {
    return saturate(mix(low, high, specular_from_color_term(luminance(color), inversion, exponent)));
}
