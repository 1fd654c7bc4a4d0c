//! A roughness made from the height: by default what stands out is worn smooth and what lies deep is rough.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro, 2010, section 1.8.2 (generated roughness by inversion, power or scale).

/// roughness_from_height(0.25, 1.0, 1.0, 0.4, 0.8) == 0.7 +- 1e-5
/// roughness_from_height(0.5, 0.0, 2.0, 0.0, 1.0) == 0.25 +- 1e-5
/// -> Perceptual roughness. 0..1
fn roughness_from_height(
    /// Of the material's own relief. 0..1
    height: f32,
    /// 1 makes deep parts the rougher ones, 0 the high ones. 0..1 = 1.0
    inversion: f32,
    /// More than 1 keeps roughness to the extreme parts. 0.1..16 = 1.0
    exponent: f32,
    /// Roughness of the smoothest parts. 0..1 = 0.5
    low: f32,
    /// Roughness of the roughest parts. 0..1 = 1.0
    high: f32,
) -> f32 {
    return saturate(mix(low, high, specular_from_color_term(height, inversion, exponent)));
}
