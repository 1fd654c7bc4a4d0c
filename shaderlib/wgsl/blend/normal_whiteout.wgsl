//! Adds the tilts of both and multiplies their uprightness: cheap, and keeps the detail.
//! Source: Oat, "Animated Wrinkle Maps", SIGGRAPH 2007 course, as discussed by Barré-Brisebois and Hill, "Blending in Detail", 2012 (whiteout blending).

/// normal_whiteout(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.0, 1.0)) == vec3f(0.6, 0.0, 0.8) +- 1e-5
/// normal_whiteout(vec3f(0.0, 0.0, 1.0), vec3f(0.0, 0.6, 0.8)) == vec3f(0.0, 0.6, 0.8) +- 1e-5
/// normal_whiteout(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.6, 0.8)) == vec3f(0.5645324, 0.5645324, 0.6021679) +- 1e-5
/// -> Unit length, z out of the ground. -1..1
fn normal_whiteout(
    /// Of the coarser surface, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    base: vec3f,
    /// Of the detail on it, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    detail: vec3f,
) -> vec3f {
    let tilt = base.xy + detail.xy;
    return unit_vector_or(vec3f(tilt, base.z * detail.z), vec3f(0.0, 0.0, 1.0));
}
