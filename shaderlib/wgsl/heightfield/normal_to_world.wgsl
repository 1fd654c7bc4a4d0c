//! A tangent-space normal as it stands on the ground: the turn that carries straight up to the ground's normal carries it too.
//! On flat ground x is east, y is south and z is up; the frame is turned by the shortest way, so it never twists.
//! Source: Barré-Brisebois and Hill, "Blending in Detail", 2012 (reoriented normal mapping), with the ground's normal as base.

/// normal_to_world(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 1.0, 0.0)) == vec3f(0.6, 0.8, 0.0) +- 1e-6
/// normal_to_world(vec3f(0.0, 0.6, 0.8), vec3f(0.0, 1.0, 0.0)) == vec3f(0.0, 0.8, 0.6) +- 1e-6
/// normal_to_world(vec3f(0.0, 0.0, 1.0), vec3f(0.48, 0.6, 0.64)) == vec3f(0.48, 0.6, 0.64) +- 1e-6
/// normal_to_world(vec3f(0.6, 0.0, 0.8), vec3f(0.6, 0.8, 0.0)) == vec3f(0.96, 0.28, 0.0) +- 1e-6
/// -> Unit length, in world space. -1..1
fn normal_to_world(
    /// Relative to the ground, z out of it. -1..1
    normal: vec3f,
    /// The ground's normal in world space, y up. -1..1 = (0.0, 1.0, 0.0)
    ground: vec3f,
) -> vec3f {
    let n = unit_vector_or(normal, vec3f(0.0, 0.0, 1.0)).xzy;
    let g = unit_vector_or(ground, vec3f(0.0, 1.0, 0.0));
    // Half a turn about up and half a turn about t is the arc from up to g. Ground never overhangs: t.y stays away from 0.
    let t = vec3f(g.x, 1.0 + g.y, g.z);
    let half_turned = vec3f(-n.x, n.y, -n.z);
    let turned = t * (dot(half_turned, t) / max(t.y, 1e-6)) - half_turned;
    return unit_vector_or(turned, g);
}
