//! Layers of rock: a random tone for every bed, of uneven thickness, along the height.
//! Source: Terrane; value noise in one dimension (Ebert et al., "Texturing and Modeling", 3rd edition, 2003, chapter 2).

/// strata(12.0, 4.0, 1.0, 0.0, 0u) == 0.12243980 +- 1e-6
/// strata(10.0, 4.0, 0.0, 0.0, 0u) == 0.12243980 +- 1e-6
/// -> The tone of the bed. 0..1
fn strata(
    /// Along which the beds follow each other; bend it with noise. [m] -16384..16384
    height: f32,
    /// Mean thickness of a bed. [m] 0.01..16384 = 4.0
    thickness: f32,
    /// 0 for clean borders, 1 for gentle ones. 0..1 = 0.3
    softness: f32,
    /// How uneven the beds are. 0..1 = 0.7
    variety: f32,
    /// Another seed gives other rock. 0..65535 = 0
    seed: u32,
) -> f32 {
    let level = height / max(thickness, 0.01);
    let bed = floor(level);
    let index = i32(bed);
    let here = strata_hash(index, seed);
    let after = strata_hash(index + 1, seed);
    // The border lies somewhere in the bed; softness widens it without leaving the bed.
    let border = 0.5 + 0.5 * variety * (hash_unit(here.y) - 0.5);
    let reach = softness * min(border, 1.0 - border);
    let passed = ramp_smooth(level - bed, border - reach, border + reach);
    return saturate(mix(hash_unit(here.x), hash_unit(after.x), passed));
}

/// Random words for a bed.
fn strata_hash(bed: i32, seed: u32) -> vec3u {
    return hash_pcg3d(vec3u(bitcast<u32>(bed), 0x9e3779b9u, seed));
}
