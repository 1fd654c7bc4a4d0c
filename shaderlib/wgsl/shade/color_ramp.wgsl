//! A colour from a value: three colours at 0, a middle and 1.
//! Source: Terrane; linear interpolation in linear light.

/// color_ramp(0.0, vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0), 0.5) == vec3f(1.0, 0.0, 0.0) +- 1e-6
/// color_ramp(0.25, vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0), 0.5) == vec3f(0.5, 0.5, 0.0) +- 1e-6
/// color_ramp(0.8, vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0), 0.6) == vec3f(0.0, 0.5, 0.5) +- 1e-6
/// color_ramp(1.0, vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0), 1.0) == vec3f(0.0, 1.0, 0.0) +- 1e-6
/// -> Linear Rec. 709. 0..1
fn color_ramp(
    /// What decides. 0..1
    x: f32,
    /// Colour at 0. 0..1 = (0.0, 0.0, 0.0)
    low: vec3f,
    /// Colour in the middle. 0..1 = (0.5, 0.5, 0.5)
    middle: vec3f,
    /// Colour at 1. 0..1 = (1.0, 1.0, 1.0)
    high: vec3f,
    /// Where the middle is. 0..1 = 0.5
    at: f32,
) -> vec3f {
    let lower = mix(low, middle, select(ramp(x, 0.0, at), 1.0, x >= at));
    let upper = select(ramp(x, at, 1.0), 0.0, x <= at);
    return saturate(mix(lower, high, upper));
}
