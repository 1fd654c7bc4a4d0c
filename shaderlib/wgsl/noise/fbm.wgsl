//! Fractal sum of noise, every octave finer and turned: the workhorse of natural variation.
//! Its spread does not depend on the number of octaves, so a ramp behind it keeps its meaning.
//! Octaves that a pixel is too large to show fade to their mean, and are not computed.
//! Source: Musgrave, in Ebert et al., "Texturing and Modeling: A Procedural Approach", 3rd edition, 2003, chapter 16 (fBm); Norton et al., "Clamping", 1982.

/// fbm(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 1u, 0.5, 3u) == 0.4477987 +- 1e-5
/// fbm(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u, 0.5, 3u) == 0.4661109 +- 1e-5
/// fbm(Place(vec2i(1024000, -512000), vec3f(3.0, 5.0, 1.0), vec3f(0.0), vec3f(0.0)), 32.0, 5u, 0.6, 1u) == 0.5600644 +- 1e-4
/// -> Around 0.5, two thirds within 0.15 of it whatever the octaves. 0..1
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
            sum += amplitude * kept * value_gradient_noise_at(lattice, 16u * seed + octave);
        }
        total += amplitude * amplitude;
        amplitude *= persistence;
        size *= LATTICE_FINER;
        lattice = lattice_octave(lattice);
    }
    return saturate(0.5 + FBM_SPREAD * sum / sqrt(max(total, 1.0)));
}

/// Makes the standard deviation 0.15: that of one octave, measured, is 0.259, and those of several add up as squares.
const FBM_SPREAD: f32 = 0.58;
