//! Fractal sum of folded noise: round lumps with creases between them, like moss, cumulus or boulders.
//! Source: Ebert et al., "Texturing and Modeling: A Procedural Approach", 3rd edition, 2003 (Perlin's turbulence, sums of |noise|).

/// billow(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u, 0.5, 3u) == 0.1749209 +- 1e-5
/// billow(Place(vec2i(1024000, -512000), vec3f(3.0, 5.0, 1.0), vec3f(0.0), vec3f(0.0)), 32.0, 5u, 0.6, 1u) == 0.6233804 +- 1e-4
/// -> 0 in the creases. 0..1
fn billow(
    /// Where.
    position: Place,
    /// Size of the largest lumps. [m] 0.01..16384 = 16.0
    wavelength: f32,
    /// How many sizes of lumps, each 2.24 times smaller. const 1..10 = 4
    octaves: u32,
    /// Height of a lump over that of the next larger. 0..1 = 0.5
    persistence: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> f32 {
    let footprint = place_footprint(position);
    var lattice = place_lattice(position, wavelength);
    var size = wavelength;
    var amplitude = 1.0;
    var sum = 0.0;
    var total = 0.0;
    for (var octave = 0u; octave < octaves; octave++) {
        let kept = lattice_kept(size, footprint);
        var lump = BILLOW_MEAN;
        if (kept > 0.0) {
            let fold = abs(value_gradient_noise_at(lattice, 16u * seed + octave));
            lump = mix(BILLOW_MEAN, fold * (2.0 - fold), kept);
        }
        sum += amplitude * lump;
        total += amplitude;
        amplitude *= persistence;
        size *= LATTICE_FINER;
        lattice = lattice_octave(lattice);
    }
    return saturate(sum / max(total, 1.0));
}

/// Mean of a lump, measured: what is left of an octave that is too fine to be seen.
const BILLOW_MEAN: f32 = 0.357;
