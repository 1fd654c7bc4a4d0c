//! Turns the hue of a colour; greys stay as they are.
//! Source: Haeberli, "Matrix Operations for Image Processing", 1993 (rotation about the grey axis).

/// hue_shift(vec3f(0.4, 0.4, 0.4), 77.0) == vec3f(0.4, 0.4, 0.4) +- 1e-6
/// hue_shift(vec3f(0.7, 0.2, 0.1), 120.0) == vec3f(0.1, 0.7, 0.2) +- 1e-5
/// hue_shift(vec3f(0.7, 0.2, 0.1), -120.0) == vec3f(0.2, 0.1, 0.7) +- 1e-5
/// -> Linear Rec. 709, held at 0 and 1. 0..1
fn hue_shift(
    /// Linear Rec. 709. 0..1
    color: vec3f,
    /// From red over green to blue. [deg] -360..360 = 0.0
    angle: f32,
) -> vec3f {
    let turn = angle_unit(angle);
    let mean = (color.r + color.g + color.b) / 3.0;
    // Rodrigues' rotation about (1, 1, 1) / sqrt(3).
    let side = (color.brg - color.gbr) * 0.57735026;
    return saturate(vec3f(mean) + (color - mean) * turn.x + side * turn.y);
}
