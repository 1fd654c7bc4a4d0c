//! Where on the terrain: a corner in whole 1/256 m and metres from it, so that no large float is ever needed.
//! Source: Terrane; fixed-point origins after Thorne, "Using a Floating Origin to Improve Fidelity and Performance of Large, Distributed Virtual Worlds", 2005.

/// Where on the terrain: never a large float. x east, y up, z south.
struct Place {
    /// x and z of the patch's corner in 1/256 m; up to 8,000 km either way.
    origin: vec2i,
    /// Metres from that corner; y is the height above 0.
    local: vec3f,
    /// Change of the position in metres per pixel to the right.
    ddx: vec3f,
    /// Change of the position in metres per pixel down.
    ddy: vec3f,
}

/// Units of `origin` in a metre.
const PLACE_UNITS: f32 = 256.0;

/// Longest period in units, 16384 m: f32 still counts every unit of it.
const PLACE_LONGEST: i32 = 4194304;

/// Lengths in metres as whole units, at least one.
fn place_periods(metres: vec2f) -> vec2i {
    return clamp(vec2i(round(metres * PLACE_UNITS)), vec2i(1), vec2i(PLACE_LONGEST));
}

/// The square grid of a wavelength in metres, at a place.
fn place_lattice(position: Place, wavelength: f32) -> Lattice {
    return place_lattice_xz(position, vec2f(wavelength));
}

/// A grid with one wavelength along x and another along z.
///
/// The cell comes from integers alone: |origin| + |256 local| < 2^31, and |cut * period| <= |corner|, so nothing overflows.
fn place_lattice_xz(position: Place, wavelengths: vec2f) -> Lattice {
    let period = place_periods(wavelengths);
    let units = position.local.xz * PLACE_UNITS;
    let corner = position.origin + vec2i(floor(units));
    // Integer division cuts toward zero; west and north of the origin the cell is one further.
    let cut = corner / period;
    let rest = corner - cut * period;
    let behind = rest < vec2i(0);
    let cell = select(cut, cut - vec2i(1), behind);
    let inside = select(rest, rest + period, behind);
    let along = (vec2f(inside) + (units - floor(units))) / vec2f(period);
    return Lattice(cell, min(along, vec2f(LATTICE_BELOW_ONE)));
}

/// Texture coordinates that repeat with a period in metres: u east, v south, reduced to 0..2 so that mirrored textures still know even tiles from odd ones.
fn place_coord(position: Place, period: f32) -> Coord {
    let lattice = place_lattice(position, period);
    let metres = f32(place_periods(vec2f(period)).x) / PLACE_UNITS;
    return Coord(
        vec2f(lattice.cell & vec2i(1)) + lattice.fraction,
        position.ddx.xz / metres,
        position.ddy.xz / metres,
    );
}

/// Metres of ground under one pixel, along its longer side.
fn place_footprint(position: Place) -> f32 {
    let squares = max(dot(position.ddx.xz, position.ddx.xz), dot(position.ddy.xz, position.ddy.xz));
    // WGSL derives a square root from the inverse one, and promises nothing for 0.
    return sqrt(max(squares, 1e-24));
}

/// The place some metres east and south of another, with the same gradients.
fn place_moved(position: Place, offset: vec2f) -> Place {
    let local = position.local + vec3f(offset.x, 0.0, offset.y);
    return Place(position.origin, local, position.ddx, position.ddy);
}
