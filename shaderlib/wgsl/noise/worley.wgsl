//! Distances to the nearest and second nearest of points strewn over the ground: cells, pebbles, scales.
//! Source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996.

/// What lies around a point.
struct Worley {
    /// Distance to the nearest point, in wavelengths. 0..1.18
    f1: f32,
    /// Distance to the second nearest point, in wavelengths. 0..1.18
    f2: f32,
    /// A random number, the same within the cell of the nearest point. 0..1
    id: f32,
}

/// worley(Place(vec2i(0, 0), vec3f(4.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.0, 0u).f1 == 0.0 +- 1e-6
/// worley(Place(vec2i(0, 0), vec3f(4.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.0, 0u).f2 == 1.0 +- 1e-6
/// worley(Place(vec2i(0, 0), vec3f(6.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.0, 0u).f2 == 0.75 +- 1e-6
fn worley(
    /// Where.
    position: Place,
    /// Mean distance between neighbours. [m] 0.01..16384 = 4.0
    wavelength: f32,
    /// 0 for a square grid of points, 1 for the most irregular one. 0..1 = 1.0
    jitter: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> Worley {
    let lattice = place_lattice(position, wavelength);
    var near = vec2f(9.0);
    var nearest = 0u;
    for (var z = -1; z <= 1; z++) {
        for (var x = -1; x <= 1; x++) {
            let random = lattice_hash(lattice.cell + vec2i(x, z), seed);
            let away = worley_point(random, jitter) + vec2f(vec2i(x, z)) - lattice.fraction;
            let square = dot(away, away);
            nearest = select(nearest, random.z, square < near.x);
            near = select(vec2f(near.x, min(near.y, square)), vec2f(square, near.x), square < near.x);
        }
    }
    let distances = clamp(sqrt(max(near, vec2f(1e-16))), vec2f(0.0), vec2f(1.18));
    return Worley(distances.x, distances.y, hash_unit(nearest));
}

/// Where in its cell a point lies.
fn worley_point(random: vec3u, jitter: f32) -> vec2f {
    return 0.5 + (hash_unit2(random.xy) - 0.5) * (jitter * WORLEY_SPREAD);
}

/// Width of the part of a cell in which its point may lie.
///
/// With s = 0.656 / 2, every point outside the 3x3 cells is at least 1.5 - s = 1.172 away, and at least two points inside
/// are nearer: the worst place is a corner, where four cells' points are at most sqrt(2) (0.5 + s) = 1.171 away.
/// So nine cells give exact first and second distances; with points anywhere in a cell they would not.
const WORLEY_SPREAD: f32 = 0.656;
