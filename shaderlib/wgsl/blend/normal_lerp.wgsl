//! From one normal to another by their slopes, as the heights below them would blend; never flattens as a plain lerp does.
//! Several layers: sum the weighted tilts of `normal_lerp_tilt`, and stand the sum up with `normal_lerp_upright`.
//! Source: Mikkelsen, "Surface Gradient-Based Bump Mapping Framework", JCGT 9(3), 2020 (gradients blend linearly).

/// normal_lerp(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.0, 1.0), 0.0) == vec3f(0.6, 0.0, 0.8) +- 1e-5
/// normal_lerp(vec3f(0.6, 0.0, 0.8), vec3f(-0.6, 0.0, 0.8), 0.5) == vec3f(0.0, 0.0, 1.0) +- 1e-5
/// normal_lerp(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.0, 1.0), 0.5) == vec3f(0.3511234, 0.0, 0.9363292) +- 1e-5
/// -> Unit length, z out of the ground. -1..1
fn normal_lerp(
    /// What 0 gives, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    a: vec3f,
    /// What 1 gives, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    b: vec3f,
    /// How far on the way. 0..1 = 0.5
    t: f32,
) -> vec3f {
    return normal_lerp_upright(mix(normal_lerp_tilt(a), normal_lerp_tilt(b), t));
}

/// The slope that a normal stands for: run of the normal over its rise. Steeper than 16:1 counts as 16:1.
fn normal_lerp_tilt(normal: vec3f) -> vec2f {
    return normal.xy / max(normal.z, 0.0625);
}

/// The unit normal of a slope.
fn normal_lerp_upright(tilt: vec2f) -> vec3f {
    return normalize(vec3f(tilt, 1.0));
}
