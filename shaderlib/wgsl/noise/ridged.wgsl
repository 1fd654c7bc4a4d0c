//! Sharp crests that carry finer crests, smooth valleys: ridged multifractal noise, for eroded rock and drifted snow.
//! Source: Musgrave, in Ebert et al., "Texturing and Modeling: A Procedural Approach", 3rd edition, 2003, chapter 16 (ridged multifractal, offset 1).

/// ridged(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u, 0.5, 2.0, 3u) == 0.8250791 +- 1e-5
/// ridged(Place(vec2i(1024000, -512000), vec3f(3.0, 5.0, 1.0), vec3f(0.0), vec3f(0.0)), 32.0, 5u, 0.6, 1.0, 1u) == 0.1637119 +- 1e-4
/// -> 1 on the crests. 0..1
fn ridged(
    /// Where.
    position: Place,
    /// Distance between the largest crests. [m] 0.01..16384 = 64.0
    wavelength: f32,
    /// How many sizes of crests, each 2.24 times smaller. const 1..10 = 5
    octaves: u32,
    /// Height of a crest over that of the next larger. 0..1 = 0.5
    persistence: f32,
    /// How much finer crests keep to the larger ones: low values clear the valleys of them. 0..8 = 2.0
    crowding: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> f32 {
    let footprint = place_footprint(position);
    var lattice = place_lattice(position, wavelength);
    var size = wavelength;
    var amplitude = 1.0;
    var allowed = 1.0;
    var sum = 0.0;
    var total = 0.0;
    for (var octave = 0u; octave < octaves; octave++) {
        let kept = lattice_kept(size, footprint);
        var crest = RIDGED_MEAN;
        if (kept > 0.0) {
            let fold = 1.0 - abs(value_gradient_noise_at(lattice, 16u * seed + octave));
            crest = mix(RIDGED_MEAN, fold * fold, kept);
        }
        sum += amplitude * allowed * crest;
        total += amplitude;
        allowed = saturate(crest * allowed * crowding);
        amplitude *= persistence;
        size *= LATTICE_FINER;
        lattice = lattice_octave(lattice);
    }
    return saturate(sum / max(total, 1.0));
}

/// Mean of a crest, measured: what is left of an octave that is too fine to be seen.
const RIDGED_MEAN: f32 = 0.643;
