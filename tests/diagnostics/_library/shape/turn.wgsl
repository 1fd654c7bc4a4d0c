//! Turns a direction in the plane.
//! Source: test.

/// turn(vec2f(1.0, 0.0), 0.0).x == 1.0 +- 0.0
/// -> The direction.
fn turn(
    /// The direction.
    direction: vec2f,
    /// How far. [rad] = 0.0
    angle: f32,
) -> vec2f {
    return vec2f(direction.x * cos(angle) - direction.y * sin(angle), direction.x * sin(angle) + direction.y * cos(angle));
}
