//! Makes a colour greyer or more vivid at the same luminance.
//! Source: Haeberli, "Matrix Operations for Image Processing", 1993 (saturation), with the weights of ITU-R BT.709.

/// saturation(vec3f(0.5, 0.25, 1.0), 0.0) == vec3f(0.3573, 0.3573, 0.3573) +- 1e-6
/// saturation(vec3f(0.5, 0.25, 1.0), 1.0) == vec3f(0.5, 0.25, 1.0) +- 1e-6
/// saturation(vec3f(0.5, 0.25, 0.5), 2.0) == vec3f(0.6788, 0.1788, 0.6788) +- 1e-5
/// -> Linear Rec. 709, held at 0 and 1. 0..1
fn saturation(
    /// Linear Rec. 709. 0..1
    color: vec3f,
    /// 0 is grey, 1 changes nothing. 0..4 = 1.0
    amount: f32,
) -> vec3f {
    return saturate(mix(vec3f(luminance(color)), color, amount));
}
