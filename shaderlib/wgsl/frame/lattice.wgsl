//! A point on a grid of stated period: the cell is an integer, so noise is as good a thousand kilometres away as at the corner.
//! Source: Terrane.

/// A point on a grid of stated period, exact however far from the terrain's corner.
struct Lattice {
    /// The grid cell.
    cell: vec2i,
    /// Where in the cell, from 0 up to but not including 1.
    fraction: vec2f,
}

/// The largest f32 under 1.
const LATTICE_BELOW_ONE: f32 = 0.99999994;

/// Wavelength of an octave over that of the one before: 1 / sqrt(5).
const LATTICE_FINER: f32 = 0.4472136;

/// Moves every octave, so that the lattice points of two octaves never fall together. Exact in f32.
const LATTICE_SHIFT: vec2f = vec2f(0.34375, 0.71875);

/// The grid of the next octave: sqrt(5) times finer and turned by atan(1/2) = 26.57 degrees.
///
/// (x, y) -> (2x - y, x + 2y) maps whole numbers to whole numbers, so cells stay exact; the angle is no fraction of a
/// turn, so no two octaves share a direction and no grid shows through.
fn lattice_octave(lattice: Lattice) -> Lattice {
    let c = lattice.cell;
    let f = lattice.fraction;
    let along = vec2f(2.0 * f.x - f.y, f.x + 2.0 * f.y) + LATTICE_SHIFT;
    let whole = floor(along);
    let cell = vec2i(2 * c.x - c.y, c.x + 2 * c.y) + vec2i(whole);
    return Lattice(cell, min(along - whole, vec2f(LATTICE_BELOW_ONE)));
}

/// How a change of position in the coarser grid appears in the next octave's.
fn lattice_octave_gradient(gradient: mat2x2f) -> mat2x2f {
    return mat2x2f(2.0, 1.0, -1.0, 2.0) * gradient;
}

/// How much of an octave a pixel can show: 1 where a wave spans four pixels, 0 where it spans two (Nyquist).
/// Both in metres. After Norton, Rockwood and Skolmoski, "Clamping", 1982.
fn lattice_kept(wavelength: f32, footprint: f32) -> f32 {
    let limit = max(2.0 * footprint, 1e-9);
    return saturate((wavelength - limit) / limit);
}

/// Three random words for a corner of the grid.
fn lattice_hash(cell: vec2i, seed: u32) -> vec3u {
    return hash_pcg3d(vec3u(bitcast<vec2u>(cell), seed));
}

/// Perlin's quintic: first and second derivative are 0 at both ends.
fn lattice_fade(f: vec2f) -> vec2f {
    return f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
}

/// Its derivative.
fn lattice_fade_slope(f: vec2f) -> vec2f {
    let g = f * (1.0 - f);
    return 30.0 * g * g;
}
