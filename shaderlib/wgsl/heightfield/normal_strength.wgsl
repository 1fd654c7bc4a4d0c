//! Flattens a normal or makes it steeper, as if the heights below it were scaled.
//! Source: Mikkelsen, "Surface Gradient-Based Bump Mapping Framework", JCGT 9(3), 2020 (gradients scale linearly).

/// normal_strength(vec3f(0.6, 0.0, 0.8), 1.0) == vec3f(0.6, 0.0, 0.8) +- 1e-5
/// normal_strength(vec3f(0.6, 0.0, 0.8), 0.0) == vec3f(0.0, 0.0, 1.0) +- 1e-6
/// normal_strength(vec3f(0.6, 0.0, 0.8), 2.0) == vec3f(0.8320503, 0.0, 0.5547002) +- 1e-5
/// -> Unit length, z out of the ground. -1..1
fn normal_strength(
    /// z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    normal: vec3f,
    /// 0 is flat, 1 changes nothing. 0..8 = 1.0
    amount: f32,
) -> vec3f {
    return layer_normal(amount * layer_slopes(normal));
}
