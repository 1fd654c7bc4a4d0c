//! Lays the detail's normal onto the tilted base, as if the detail were glued to it: nothing flattens.
//! Source: Barré-Brisebois and Hill, "Blending in Detail", 2012 (reoriented normal mapping).

/// normal_reorient(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.0, 1.0)) == vec3f(0.6, 0.0, 0.8) +- 1e-5
/// normal_reorient(vec3f(0.0, 0.0, 1.0), vec3f(0.0, 0.6, 0.8)) == vec3f(0.0, 0.6, 0.8) +- 1e-5
/// normal_reorient(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.6, 0.8)) == vec3f(0.48, 0.6, 0.64) +- 1e-5
/// normal_reorient(vec3f(0.6, 0.0, 0.8), vec3f(0.6, 0.0, 0.8)) == vec3f(0.96, 0.0, 0.28) +- 1e-5
/// -> Unit length, z out of the ground. -1..1
fn normal_reorient(
    /// Of the coarser surface, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    base: vec3f,
    /// Of the detail on it, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    detail: vec3f,
) -> vec3f {
    let t = vec3f(base.xy, base.z + 1.0);
    let u = vec3f(-detail.xy, detail.z);
    return unit_vector_or(t * dot(t, u) - u * t.z, vec3f(0.0, 0.0, 1.0));
}
