//! A specular intensity made from the colour, so that it needs no texture: inverted, raised to a power and scaled.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro, 2010, section 1.8.2 (specular from diffuse by inversion, power or scale).

/// specular_from_color(vec3f(0.5, 0.5, 0.5), 0.0, 2.0, 0.4) == 0.1 +- 1e-5
/// specular_from_color(vec3f(0.2, 0.2, 0.2), 1.0, 1.0, 0.5) == 0.4 +- 1e-5
/// -> Specular intensity. 0..1
fn specular_from_color(
    /// Linear Rec. 709. 0..1
    color: vec3f,
    /// 1 makes dark parts shine instead of light ones. 0..1 = 0.0
    inversion: f32,
    /// More than 1 keeps the shine to the brightest parts. 0.1..16 = 1.0
    exponent: f32,
    /// Intensity where the term is 1. 0..1 = 0.08
    scale: f32,
) -> f32 {
    return saturate(scale * specular_from_color_term(luminance(color), inversion, exponent));
}

/// Inversion and power of a value 0..1.
fn specular_from_color_term(x: f32, inversion: f32, exponent: f32) -> f32 {
    let t = saturate(mix(x, 1.0 - x, inversion));
    return select(saturate(pow(max(t, 1e-20), exponent)), 0.0, t <= 0.0);
}
