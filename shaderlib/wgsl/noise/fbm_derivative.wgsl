//! Fractal noise and its exact slope: heights whose normals cost nothing extra.
//! Source: Quilez, "Gradient Noise Derivatives", 2017, summed as fBm (Musgrave, in Ebert et al., "Texturing and Modeling", 3rd edition, 2003, chapter 16).

/// Fractal noise with its slope.
struct FbmDerivative {
    /// As `fbm` gives it. 0..1
    value: f32,
    /// Rise per metre to the east and to the south. [1/m] -1000000..1000000
    slope: vec2f,
}

/// fbm_derivative(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u, 0.5, 3u).value == 0.4661109 +- 1e-5
/// fbm_derivative(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3u, 0.5, 3u).slope == vec2f(0.0518048, 0.2023389) +- 1e-5
fn fbm_derivative(
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
) -> FbmDerivative {
    let footprint = place_footprint(position);
    var lattice = place_lattice(position, wavelength);
    // Its columns say how the octave's cells move with x and with z, in units of the first octave's.
    var turn = mat2x2f(1.0, 0.0, 0.0, 1.0);
    var size = wavelength;
    var amplitude = 1.0;
    var sum = vec3f(0.0);
    var total = 0.0;
    for (var octave = 0u; octave < octaves; octave++) {
        let kept = lattice_kept(size, footprint);
        if (kept > 0.0) {
            let noise = value_gradient_noise_slope_at(lattice, 16u * seed + octave);
            sum += amplitude * kept * vec3f(noise.x, noise.yz * turn);
        }
        total += amplitude * amplitude;
        amplitude *= persistence;
        size *= LATTICE_FINER;
        lattice = lattice_octave(lattice);
        turn = lattice_octave_gradient(turn);
    }
    let spread = FBM_SPREAD * sum / sqrt(max(total, 1.0));
    // Where the value is held at 0 or 1 the ground is flat.
    let held = abs(spread.x) >= 0.5;
    return FbmDerivative(saturate(0.5 + spread.x), select(spread.yz / wavelength, vec2f(0.0), held));
}
