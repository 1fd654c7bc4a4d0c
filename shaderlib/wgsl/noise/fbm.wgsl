//! Fractal sum of gradient noise, every octave finer and turned: the workhorse of natural variation.
//! Octaves that a pixel is too large to show fade to their mean, and are not computed.
//! Source: Musgrave, in Ebert et al., "Texturing and Modeling: A Procedural Approach", 3rd edition, 2003, chapter 16 (fBm); Norton et al., "Clamping", 1982.

/// fbm(Place(vec2i(512, -1024), vec3f(0.0), vec3f(0.0), vec3f(0.0)), 2.0, 1u, 0.5, 3u) == 0.5 +- 1e-6
/// -> Mostly 0.3 to 0.7, around 0.5. 0..1
fn fbm(
    /// Where.
    position: Place,
    /// Size of the largest waves. [m] 0.01..16384 = 32.0
    wavelength: f32,
    /// How many sizes of waves, each 2.24 times smaller. const 1..10 = 5
    octaves: u32,
    /// Height of a wave over that of the next larger. 0..1 = 0.5
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
        if (kept > 0.0) {
            sum += amplitude * kept * gradient_noise_at(lattice, 16u * seed + octave);
        }
        total += amplitude;
        amplitude *= persistence;
        size *= LATTICE_FINER;
        lattice = lattice_octave(lattice);
    }
    return saturate(0.5 + 0.5 * sum / max(total, 1.0));
}
