//! Bends the ground under a pattern, so that straight or regular things look grown: a place for other nodes to use.
//! Source: Quilez, "Domain Warping", 2002; the gradients follow by the chain rule from the noise's own slope.

/// warp(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.0), vec3f(0.0)), 8.0, 3.0, 1u, 3u).local == vec3f(3.4806478, 0.0, 0.7649994) +- 1e-5
/// warp(Place(vec2i(0, 0), vec3f(3.0, 0.0, 1.0), vec3f(0.25, 0.0, 0.0), vec3f(0.0)), 8.0, 3.0, 1u, 3u).ddx == vec3f(0.2798481, 0.0, -0.0296623) +- 1e-5
/// -> The moved place, with its gradients.
fn warp(
    /// Where.
    position: Place,
    /// Size of the largest bends. [m] 0.01..16384 = 32.0
    wavelength: f32,
    /// How far it moves at most. [m] 0..4096 = 4.0
    amount: f32,
    /// How many sizes of bends, each 2.24 times smaller. const 1..6 = 2
    octaves: u32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> Place {
    let footprint = place_footprint(position);
    var lattice = place_lattice(position, wavelength);
    var turn = mat2x2f(1.0, 0.0, 0.0, 1.0);
    var size = wavelength;
    var amplitude = 0.5;
    var east = vec3f(0.0);
    var south = vec3f(0.0);
    for (var octave = 0u; octave < octaves; octave++) {
        let kept = lattice_kept(size, footprint);
        if (kept > 0.0) {
            // Far from the seeds of `fbm`: a pattern must not be bent along itself.
            let key = 0x40000000u + 32u * seed + 2u * octave;
            let a = value_gradient_noise_slope_at(lattice, key);
            let b = value_gradient_noise_slope_at(lattice, key + 1u);
            east += amplitude * kept * vec3f(a.x, a.yz * turn);
            south += amplitude * kept * vec3f(b.x, b.yz * turn);
        }
        amplitude *= 0.5;
        size *= LATTICE_FINER;
        lattice = lattice_octave(lattice);
        turn = lattice_octave_gradient(turn);
    }
    let moved = place_moved(position, amount * vec2f(east.x, south.x));
    let stretch = mat2x2f(east.yz, south.yz) * (amount / wavelength);
    return Place(
        moved.origin,
        moved.local,
        position.ddx + warp_gradient(position.ddx, stretch),
        position.ddy + warp_gradient(position.ddy, stretch),
    );
}

/// What the warp adds to a change of place.
fn warp_gradient(change: vec3f, stretch: mat2x2f) -> vec3f {
    let added = change.xz * stretch;
    return vec3f(added.x, 0.0, added.y);
}
