//! Adds the slopes of both, as the heights of both would add.
//! Source: Barré-Brisebois and Hill, "Blending in Detail", 2012 (partial derivative blending).

/// normal_partial(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.0, 1.0)) == vec3f(0.6, 0.0, 0.8) +- 1e-5
/// normal_partial(vec3f(0.0, 0.0, 1.0), vec3f(0.0, 0.6, 0.8)) == vec3f(0.0, 0.6, 0.8) +- 1e-5
/// normal_partial(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.6, 0.8)) == vec3f(0.5144958, 0.5144958, 0.6859943) +- 1e-5
/// normal_partial(vec3f(0.6, 0.0, 0.8), vec3f(0.6, 0.0, 0.8)) == vec3f(0.8320503, 0.0, 0.5547002) +- 1e-5
/// -> Unit length, z out of the ground. -1..1
fn normal_partial(
    /// Of the coarser surface, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    base: vec3f,
    /// Of the detail on it, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    detail: vec3f,
) -> vec3f {
    let tilt = base.xy * detail.z + detail.xy * base.z;
    return unit_vector_or(vec3f(tilt, base.z * detail.z), vec3f(0.0, 0.0, 1.0));
}
