//! How bright a linear colour looks.
//! Source: ITU-R BT.709-6, 2015, section 3.2 (luma weights, applied to linear light: CIE Y).

/// luminance(vec3f(1.0, 1.0, 1.0)) == 1.0 +- 1e-6
/// luminance(vec3f(0.5, 0.25, 1.0)) == 0.3573 +- 1e-6
/// -> Relative luminance. 0..1000
fn luminance(
    /// Linear Rec. 709. 0..1000
    color: vec3f,
) -> f32 {
    return min(dot(color, vec3f(0.2126, 0.7152, 0.0722)), 1000.0);
}
