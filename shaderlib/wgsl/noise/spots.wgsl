//! Round spots strewn over the ground, each of its own size: stones, tufts, flowers, lichen.
//! Source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996, one feature point a cell.

/// Spots and what tells them apart.
struct Spots {
    /// 1 within a spot, 0 between spots. 0..1
    mask: f32,
    /// 1 in the middle of the spot, 0 at its border and between spots: a dome for heights. 0..1
    dome: f32,
    /// A random number, the same within one spot. 0..1
    id: f32,
}

/// spots(Place(vec2i(0, 0), vec3f(4.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.3, 0.0, 0.1, 0.0, 0u).mask == 1.0 +- 1e-6
/// spots(Place(vec2i(0, 0), vec3f(5.2, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.3, 0.0, 0.1, 0.0, 0u).dome == 0.75 +- 1e-5
/// spots(Place(vec2i(0, 0), vec3f(0.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.3, 0.0, 0.1, 0.0, 0u).mask == 0.0 +- 1e-6
fn spots(
    /// Where.
    position: Place,
    /// Mean distance between neighbours. [m] 0.01..16384 = 1.0
    wavelength: f32,
    /// Radius of the largest spot over the distance between neighbours. 0.01..0.5 = 0.35
    radius: f32,
    /// How much smaller the smallest spot is: 0 makes all equal, 1 lets some vanish. 0..1 = 0.6
    variety: f32,
    /// Softness of the border over the radius. 0..1 = 0.2
    softness: f32,
    /// 0 for a square grid of spots, 1 for the most irregular one. 0..1 = 1.0
    jitter: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> Spots {
    let lattice = place_lattice(position, wavelength);
    var best = Spots(0.0, 0.0, 0.0);
    for (var z = -1; z <= 1; z++) {
        for (var x = -1; x <= 1; x++) {
            let random = lattice_hash(lattice.cell + vec2i(x, z), seed);
            let away = worley_point(random, jitter) + vec2f(vec2i(x, z)) - lattice.fraction;
            let id = hash_unit(random.z);
            let size = max(radius * (1.0 - variety * id), 1e-4);
            let inside = 1.0 - sqrt(max(dot(away, away), 1e-16)) / size;
            // 1 - r^2 is (1 - r)(1 + r): a round dome.
            let dome = saturate(inside * (2.0 - inside));
            if (inside > 0.0 && dome >= best.dome) {
                best = Spots(ramp_smooth(inside, 0.0, softness), dome, id);
            }
        }
    }
    return best;
}
