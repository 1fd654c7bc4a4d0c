//! A vector's direction: length 1, or a stated one where the vector is 0.
//! Source: Terrane; WGSL's normalize is undefined for 0, see W3C, "WebGPU Shading Language", section 17.5 (normalize).

/// unit_vector(vec3f(3.0, 0.0, -4.0)) == vec3f(0.6, 0.0, -0.8) +- 1e-6
/// unit_vector(vec3f(0.0, 0.0, 0.0)) == vec3f(0.0, 1.0, 0.0) +- 0
/// unit_vector(vec3f(0.0, 0.000001, 0.0)) == vec3f(0.0, 1.0, 0.0) +- 1e-6
/// -> Straight up where there is no direction. -1..1
fn unit_vector(
    /// Of any length. -1000000..1000000
    v: vec3f,
) -> vec3f {
    return unit_vector_or(v, vec3f(0.0, 1.0, 0.0));
}

/// The direction of `v`, or `otherwise` where every component is under 1e-18. Components up to 1e18 do no harm.
///
/// Scaled by the largest component first: the square of a small one would vanish.
fn unit_vector_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let a = abs(v);
    let largest = max(a.x, max(a.y, a.z));
    let scaled = v / max(largest, 1e-18);
    let usable = largest >= 1e-18;
    let direction = normalize(select(vec3f(0.0, 1.0, 0.0), scaled, usable));
    return select(otherwise, clamp(direction, vec3f(-1.0), vec3f(1.0)), usable);
}
