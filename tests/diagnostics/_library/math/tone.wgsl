//! Lifts dark values. Its overload for vectors comes first: order must not decide.
//! Source: test.

/// tone_vec3(vec3f(0.25), 1.0) == vec3f(0.25) +- 0.0
/// -> The lifted value.
fn tone_vec3(
    /// What to lift.
    x: vec3f,
    /// How much. = 1.0
    amount: f32,
) -> vec3f {
    return x * amount;
}

/// tone_f32(0.25, 1.0) == 0.25 +- 0.0
/// -> The lifted value.
fn tone_f32(
    /// What to lift.
    x: f32,
    /// How much. = 1.0
    amount: f32,
) -> f32 {
    return x * amount;
}
