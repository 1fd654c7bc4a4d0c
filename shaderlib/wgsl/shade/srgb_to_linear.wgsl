//! Decodes a colour as written in a paint program to linear light.
//! Source: IEC 61966-2-1:1999, section 5.2.

/// srgb_to_linear(vec3f(0.0, 0.5, 1.0)) == vec3f(0.0, 0.21404114, 1.0) +- 1e-5
/// srgb_to_linear(vec3f(0.04, 0.04045, 0.2)) == vec3f(0.003095975, 0.003130805, 0.033104767) +- 1e-5
/// -> Linear Rec. 709. 0..1
fn srgb_to_linear(
    /// Encoded with the sRGB curve. 0..1
    color: vec3f,
) -> vec3f {
    let dark = color / 12.92;
    let light = pow((max(color, vec3f(0.0)) + 0.055) / 1.055, vec3f(2.4));
    return saturate(select(light, dark, color <= vec3f(0.04045)));
}
