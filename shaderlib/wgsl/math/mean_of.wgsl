//! The mean of a vector's components: the plain grey of a colour.
//! Source: W3C, "WebGPU Shading Language", section 8.7 (arithmetic expressions).

/// mean_of_vec2(vec2f(1.0, 3.0)) == 2.0 +- 1e-6
/// -> The mean. -1000001..1000001
fn mean_of_vec2(
    /// What to average. -1000000..1000000
    v: vec2f,
) -> f32 {
    return (v.x + v.y) * 0.5;
}

/// mean_of_vec3(vec3f(1.0, 3.0, 5.0)) == 3.0 +- 1e-6
/// -> The mean. -1000001..1000001
fn mean_of_vec3(
    /// What to average. -1000000..1000000
    v: vec3f,
) -> f32 {
    return (v.x + v.y + v.z) * 0.33333333;
}

/// mean_of_vec4(vec4f(1.0, 3.0, 5.0, -1.0)) == 2.0 +- 1e-6
/// -> The mean. -1000001..1000001
fn mean_of_vec4(
    /// What to average. -1000000..1000000
    v: vec4f,
) -> f32 {
    return (v.x + v.y + v.z + v.w) * 0.25;
}
