//! A net of cracks: the borders between the cells of strewn points, of even width everywhere.
//! Source: Quilez, "Voronoi Borders", 2012 (distance to the border, not the difference of two distances).

/// cracks(Place(vec2i(0, 0), vec3f(0.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.1, 0.0, 0u) == 1.0 +- 1e-6
/// cracks(Place(vec2i(0, 0), vec3f(0.2, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.1, 0.0, 0u) == 0.5 +- 1e-2
/// cracks(Place(vec2i(0, 0), vec3f(4.0, 0.0, 4.0), vec3f(0.0), vec3f(0.0)), 8.0, 0.1, 0.0, 0u) == 0.0 +- 1e-6
/// -> 1 in the middle of a crack, 0 on the plates. 0..1
fn cracks(
    /// Where.
    position: Place,
    /// Mean size of a plate. [m] 0.01..16384 = 2.0
    wavelength: f32,
    /// Width of a crack over the size of a plate. 0.001..0.3 = 0.06
    width: f32,
    /// 0 for square plates, 1 for the most irregular ones. 0..1 = 1.0
    jitter: f32,
    /// Another seed gives another pattern. 0..65535 = 0
    seed: u32,
) -> f32 {
    let lattice = place_lattice(position, wavelength);
    let middle = cracks_nearest(lattice, jitter, seed);
    var border = 1.0;
    for (var z = -1; z <= 1; z++) {
        for (var x = -1; x <= 1; x++) {
            let away = cracks_away(lattice, vec2i(x, z), jitter, seed);
            let apart = away - middle;
            let gap = sqrt(max(dot(apart, apart), 1e-12));
            // The bisector of the two points; the nearest one has none with itself.
            let far = dot(0.5 * (away + middle), apart) / max(gap, 1e-3);
            border = min(border, select(far, 1.0, gap < 1e-3));
        }
    }
    let half_width = max(0.5 * width, 1e-4);
    return saturate(1.0 - max(border, 0.0) / half_width);
}

/// The way to the nearest point, in cells.
fn cracks_nearest(lattice: Lattice, jitter: f32, seed: u32) -> vec2f {
    var nearest = vec2f(9.0);
    for (var z = -1; z <= 1; z++) {
        for (var x = -1; x <= 1; x++) {
            let away = cracks_away(lattice, vec2i(x, z), jitter, seed);
            nearest = select(nearest, away, dot(away, away) < dot(nearest, nearest));
        }
    }
    return nearest;
}

/// The way to the point of a neighbouring cell, in cells.
fn cracks_away(lattice: Lattice, offset: vec2i, jitter: f32, seed: u32) -> vec2f {
    let random = lattice_hash(lattice.cell + offset, seed);
    return worley_point(random, jitter) + vec2f(offset) - lattice.fraction;
}
