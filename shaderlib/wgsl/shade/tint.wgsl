//! Colours something in another colour and keeps its luminance.
//! Source: W3C, "Compositing and Blending Level 1", 2015, section 10.2 (color blend mode), by scaling instead of shifting.

/// tint(vec3f(0.5, 0.5, 0.5), vec3f(0.4, 0.5, 0.2), 0.0) == vec3f(0.5, 0.5, 0.5) +- 1e-6
/// tint(vec3f(0.2, 0.2, 0.2), vec3f(0.4, 0.5, 0.2), 1.0) == vec3f(0.1750241, 0.2187801, 0.0875120) +- 1e-5
/// tint(vec3f(0.2, 0.2, 0.2), vec3f(0.0, 0.0, 0.0), 1.0) == vec3f(0.2, 0.2, 0.2) +- 1e-5
/// -> Linear Rec. 709, held at 1. 0..1
fn tint(
    /// Linear Rec. 709. 0..1
    color: vec3f,
    /// The colour to take on; its brightness does not matter, black does nothing. 0..1
    toward: vec3f,
    /// How much of it. 0..1 = 1.0
    amount: f32,
) -> vec3f {
    let bright = luminance(toward);
    let scaled = select(color, toward * (luminance(color) / max(bright, 1e-4)), bright > 1e-4);
    return saturate(mix(color, min(scaled, vec3f(1e4)), amount));
}
