//! A world-space normal as seen from the ground: the inverse of `normal_to_world`.
//! Source: Barré-Brisebois and Hill, "Blending in Detail", 2012 (reoriented normal mapping), run backwards.

/// normal_to_tangent(vec3f(0.6, 0.8, 0.0), vec3f(0.0, 1.0, 0.0)) == vec3f(0.6, 0.0, 0.8) +- 1e-6
/// normal_to_tangent(vec3f(0.48, 0.6, 0.64), vec3f(0.48, 0.6, 0.64)) == vec3f(0.0, 0.0, 1.0) +- 1e-6
/// normal_to_tangent(vec3f(0.96, 0.28, 0.0), vec3f(0.6, 0.8, 0.0)) == vec3f(0.6, 0.0, 0.8) +- 1e-6
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn normal_to_tangent(
    /// In world space, y up. -1..1
    normal: vec3f,
    /// The ground's normal in world space, y up. -1..1 = (0.0, 1.0, 0.0)
    ground: vec3f,
) -> vec3f {
    let n = unit_vector_or(normal, vec3f(0.0, 1.0, 0.0));
    let g = unit_vector_or(ground, vec3f(0.0, 1.0, 0.0));
    let t = vec3f(g.x, 1.0 + g.y, g.z);
    let half_turned = t * (dot(n, t) / max(t.y, 1e-6)) - n;
    return unit_vector_or(vec3f(-half_turned.x, -half_turned.z, half_turned.y), vec3f(0.0, 0.0, 1.0));
}
