//! From one normal to another by their slopes, as the heights below them would blend; never flattens as a plain lerp does.
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
    return layer_normal(mix(layer_slopes(a), layer_slopes(b), t));
}
