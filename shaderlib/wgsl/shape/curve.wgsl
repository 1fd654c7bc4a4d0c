//! A curve through four points at 0, 1/3, 2/3 and 1 that never overshoots them.
//! Source: Fritsch and Butland, "A Method for Constructing Local Monotone Piecewise Cubic Interpolants", 1984 (harmonic mean of the secants).

/// curve(0.5, 0.0, 0.3333333, 0.6666667, 1.0) == 0.5 +- 1e-6
/// curve(0.3333333, 0.1, 0.7, 0.2, 0.9) == 0.7 +- 1e-5
/// curve(0.1666667, 0.0, 0.6, 0.6, 0.0) == 0.375 +- 1e-5
/// curve(0.8333333, 0.0, 0.0, 0.0, 1.0) == 0.375 +- 1e-5
/// -> The value on the curve. 0..1
fn curve(
    /// Where on the curve. 0..1
    x: f32,
    /// Value at 0. 0..1 = 0.0
    y0: f32,
    /// Value at 1/3. 0..1 = 0.3333333
    y1: f32,
    /// Value at 2/3. 0..1 = 0.6666667
    y2: f32,
    /// Value at 1. 0..1 = 1.0
    y3: f32,
) -> f32 {
    let rise = vec3f(y1 - y0, y2 - y1, y3 - y2);
    let tangents = vec4f(rise.x, curve_tangent(rise.x, rise.y), curve_tangent(rise.y, rise.z), rise.z);
    let at = 3.0 * saturate(x);
    let part = min(floor(at), 2.0);
    let ends = select(select(vec2f(y0, y1), vec2f(y1, y2), part > 0.5), vec2f(y2, y3), part > 1.5);
    let slopes = select(select(tangents.xy, tangents.yz, part > 0.5), tangents.zw, part > 1.5);
    let t = at - part;
    // Hermite's cubic, as a straight line and what bends it.
    let line = ends.y - ends.x;
    let bend = t * (1.0 - t) * ((1.0 - t) * (slopes.x - line) - t * (slopes.y - line));
    return clamp(ends.x + t * line + bend, min(ends.x, ends.y), max(ends.x, ends.y));
}

/// Tangent between two secants: flat at a turning point.
fn curve_tangent(before: f32, after: f32) -> f32 {
    let same_way = before * after > 0.0;
    let mean = 2.0 * before * after / select(1.0, before + after, same_way);
    return select(0.0, mean, same_way);
}
