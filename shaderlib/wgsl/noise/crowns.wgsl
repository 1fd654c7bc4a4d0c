//! The crowns of a wood from above: cones that stand side by side, each of its own height.
//! Crowns that a pixel is too large to show fade to half their height.
//! Source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996, one feature point a cell; Norton et al., "Clamping", 1982.

/// The roof of a wood.
struct Crowns {
    /// 1 at the tip of the highest tree, 0 on open ground. 0..1
    height: f32,
    /// Rise per metre to the east and to the south, for a wood one metre high. [1/m] -1000..1000
    slope: vec2f,
    /// A random number, the same within one crown. 0..1
    id: f32,
}

/// crowns(Place(vec2i(0, 0), vec3f(4.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.5, 0.0, 0.0, 0u).height == 1.0 +- 1e-6
/// crowns(Place(vec2i(0, 0), vec3f(6.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.5, 0.0, 0.0, 0u).height == 0.5 +- 1e-6
/// crowns(Place(vec2i(0, 0), vec3f(6.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.5, 0.0, 0.0, 0u).slope == vec2f(-0.25, 0.0) +- 1e-6
/// crowns(Place(vec2i(0, 0), vec3f(0.0, 0.0, 0.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.5, 0.0, 0.0, 0u).height == 0.0 +- 1e-6
/// crowns(Place(vec2i(0, 0), vec3f(6.0, 0.0, 4.0), vec3f(4.0, 0.0, 0.0), vec3f(0.0)), 8.0, 0.5, 0.0, 0.0, 0u).slope == vec2f(0.0, 0.0) +- 1e-6
fn crowns(
    /// Where.
    position: Place,
    /// Mean distance between trees. [m] 0.1..1024 = 5.0
    wavelength: f32,
    /// Radius of a crown over the distance between trees. 0.1..1.1 = 0.7
    radius: f32,
    /// How much lower the lowest tree is than the highest. 0..1 = 0.5
    variety: f32,
    /// 0 for a plantation in rows, 1 for the most irregular wood. 0..1 = 1.0
    jitter: f32,
    /// Another seed gives another wood. 0..65535 = 0
    seed: u32,
) -> Crowns {
    let lattice = place_lattice(position, wavelength);
    var best = Crowns(0.0, vec2f(0.0), 0.0);
    for (var z = -1; z <= 1; z++) {
        for (var x = -1; x <= 1; x++) {
            let random = lattice_hash(lattice.cell + vec2i(x, z), seed);
            let away = worley_point(random, jitter) + vec2f(vec2i(x, z)) - lattice.fraction;
            let id = hash_unit(random.z);
            let tip = 1.0 - variety * id;
            let reach = sqrt(max(dot(away, away), 1e-16));
            let height = tip * (1.0 - reach / radius);
            if (height > best.height) {
                best = Crowns(height, away * (tip / (reach * radius)), id);
            }
        }
    }
    let kept = lattice_kept(wavelength, place_footprint(position));
    return Crowns(mix(0.5, best.height, kept), best.slope * (kept / wavelength), best.id);
}
