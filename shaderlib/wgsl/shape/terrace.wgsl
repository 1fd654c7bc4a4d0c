//! Cuts a slope into steps: flat treads with rises between them.
//! Source: Terrane; Musgrave, in Ebert et al., "Texturing and Modeling: A Procedural Approach", 3rd edition, 2003, describes strata by such a step function.

/// terrace(0.6, 2.0, 0.0) == 0.552 +- 1e-5
/// terrace(0.7, 2.0, 1.0) == 0.5 +- 1e-6
/// terrace(0.85, 2.0, 0.4) == 0.75 +- 1e-5
/// terrace(1.0, 5.0, 0.9) == 1.0 +- 0
/// -> The stepped value. 0..1
fn terrace(
    /// The value to cut. 0..1
    x: f32,
    /// How many steps. 1..64 = 4.0
    steps: f32,
    /// How much of a step is tread: 1 leaves vertical rises. 0..1 = 0.6
    sharpness: f32,
) -> f32 {
    let at = saturate(x) * steps;
    let tread = floor(at);
    return saturate((tread + ramp_smooth(at - tread, sharpness, 1.0)) / max(steps, 1.0));
}
