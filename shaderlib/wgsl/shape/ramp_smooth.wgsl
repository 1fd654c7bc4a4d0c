//! Like `ramp`, eased at both ends: WGSL's smoothstep made safe for equal and reversed edges.
//! Source: W3C, "WebGPU Shading Language", section 17.5 (smoothstep: t * t * (3 - 2 t)).

/// ramp_smooth(0.3, 0.2, 0.6) == 0.15625 +- 1e-6
/// ramp_smooth(0.3, 0.6, 0.2) == 0.84375 +- 1e-6
/// ramp_smooth(5.0, 5.0, 5.0) == 1.0 +- 0
/// -> 0 at low and before, 1 at high and beyond. 0..1
fn ramp_smooth(
    /// The value that decides. -1000000..1000000
    x: f32,
    /// Where it is still 0. -1000000..1000000 = 0.0
    low: f32,
    /// Where it is 1. -1000000..1000000 = 1.0
    high: f32,
) -> f32 {
    let t = ramp(x, low, high);
    return saturate(t * t * (3.0 - 2.0 * t));
}
