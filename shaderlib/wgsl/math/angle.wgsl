//! Sine and cosine that are good for every angle: WGSL promises 11 bits, and only from -pi to pi.
//! Source: Abramowitz and Stegun, "Handbook of Mathematical Functions", 1964, 4.3.65 and 4.3.66 (the series, cut where f32 ends).

/// Cosine and sine of an angle in degrees. Exact at whole quarters, elsewhere within 4e-7 while |degrees| < 100,000.
fn angle_unit(degrees: f32) -> vec2f {
    let quarter = round(degrees / 90.0);
    let x = (degrees - 90.0 * quarter) * 0.017453292;
    let s = x * x;
    let across = x * (1.0 - s * (0.16666667 - s * (0.008333333 - s * (0.0001984127 - s * 0.0000027557319))));
    let along = 1.0 - s * (0.5 - s * (0.041666668 - s * (0.0013888889 - s * 0.000024801588)));
    let turn = i32(quarter) & 3;
    let odd = select(vec2f(along, across), vec2f(-across, along), (turn & 1) != 0);
    return clamp(select(odd, -odd, turn >= 2), vec2f(-1.0), vec2f(1.0));
}
