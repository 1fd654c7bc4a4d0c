//! Encodes linear light with the sRGB curve, as screens and paint programs expect.
//! Source: IEC 61966-2-1:1999, section 5.2.

/// linear_to_srgb(vec3f(0.0, 0.21404114, 1.0)) == vec3f(0.0, 0.5, 1.0) +- 1e-5
/// linear_to_srgb(vec3f(0.001, 0.0031308, 0.18)) == vec3f(0.01292, 0.040449936, 0.461356) +- 1e-5
/// -> Encoded with the sRGB curve. 0..1
fn linear_to_srgb(
    /// Linear Rec. 709. 0..1
    color: vec3f,
) -> vec3f {
    let dark = color * 12.92;
    let light = 1.055 * pow(max(color, vec3f(0.0031308)), vec3f(0.41666666)) - 0.055;
    return saturate(select(light, dark, color <= vec3f(0.0031308)));
}
