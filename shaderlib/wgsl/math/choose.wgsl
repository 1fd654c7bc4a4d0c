//! One value or another, by a threshold: a hard edge.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (numeric built-in functions); section 17.4 (select).

/// choose_f32(0.7, 0.5, 1.5, 0.5) == 0.5 +- 1e-6
/// -> One of the two. -1000000..1000000
fn choose_f32(
    /// The number that decides. -1000000..1000000
    x: f32,
    /// From here on the second value holds. -1000000..1000000 = 0.5
    edge: f32,
    /// Where it is under the edge. -1000000..1000000 = 0.0
    a: f32,
    /// Where it is not. -1000000..1000000 = 1.0
    b: f32,
) -> f32 {
    return select(a, b, x >= edge);
}

/// choose_vec2(0.7, 0.5, vec2f(1.5, -2.0), vec2f(0.5, 4.0)) == vec2f(0.5, 4.0) +- 1e-6
/// -> One of the two. -1000000..1000000
fn choose_vec2(
    /// The number that decides. -1000000..1000000
    x: f32,
    /// From here on the second value holds. -1000000..1000000 = 0.5
    edge: f32,
    /// Where it is under the edge. -1000000..1000000 = (0.0, 0.0)
    a: vec2f,
    /// Where it is not. -1000000..1000000 = (1.0, 1.0)
    b: vec2f,
) -> vec2f {
    return select(a, b, x >= edge);
}

/// choose_vec3(0.7, 0.5, vec3f(1.5, -2.0, 0.25), vec3f(0.5, 4.0, -1.0)) == vec3f(0.5, 4.0, -1.0) +- 1e-6
/// -> One of the two. -1000000..1000000
fn choose_vec3(
    /// The number that decides. -1000000..1000000
    x: f32,
    /// From here on the second value holds. -1000000..1000000 = 0.5
    edge: f32,
    /// Where it is under the edge. -1000000..1000000 = (0.0, 0.0, 0.0)
    a: vec3f,
    /// Where it is not. -1000000..1000000 = (1.0, 1.0, 1.0)
    b: vec3f,
) -> vec3f {
    return select(a, b, x >= edge);
}

/// choose_vec4(0.7, 0.5, vec4f(1.5, -2.0, 0.25, 8.0), vec4f(0.5, 4.0, -1.0, 2.0)) == vec4f(0.5, 4.0, -1.0, 2.0) +- 1e-6
/// -> One of the two. -1000000..1000000
fn choose_vec4(
    /// The number that decides. -1000000..1000000
    x: f32,
    /// From here on the second value holds. -1000000..1000000 = 0.5
    edge: f32,
    /// Where it is under the edge. -1000000..1000000 = (0.0, 0.0, 0.0, 0.0)
    a: vec4f,
    /// Where it is not. -1000000..1000000 = (1.0, 1.0, 1.0, 1.0)
    b: vec4f,
) -> vec4f {
    return select(a, b, x >= edge);
}
