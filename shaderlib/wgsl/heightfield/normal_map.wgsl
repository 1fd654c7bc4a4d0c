//! A normal from the texel of a normal map.
//! Source: Barré-Brisebois and Hill, "Blending in Detail", 2012 (packing n / 2 + 1 / 2).

/// normal_map(vec4f(0.5, 0.5, 1.0, 1.0), 1.0, 0.0) == vec3f(0.0, 0.0, 1.0) +- 1e-6
/// normal_map(vec4f(0.8, 0.5, 0.9, 1.0), 1.0, 0.0) == vec3f(0.6, 0.0, 0.8) +- 1e-6
/// normal_map(vec4f(0.5, 0.8, 0.9, 1.0), 1.0, 1.0) == vec3f(0.0, -0.6, 0.8) +- 1e-6
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn normal_map(
    /// What the texture gives; red and green are the tilt. 0..1
    texel: vec4f,
    /// Factor on the tilt. 0..4 = 1.0
    strength: f32,
    /// 1 for maps whose green channel points up the image, as OpenGL's do. const 0..1 = 0.0
    flip: f32,
) -> vec3f {
    let n = texel.xyz * 2.0 - 1.0;
    let tilt = n.xy * strength * vec2f(1.0, 1.0 - 2.0 * flip);
    // A texel that points into the ground, or nowhere, is damaged: 0.0625 keeps the result finite and upright.
    return normalize(vec3f(tilt, max(n.z, 0.0625)));
}
