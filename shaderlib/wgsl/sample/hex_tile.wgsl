//! A texture without visible repetition: turned and shifted copies on a triangular grid, three at every point.
//! Source: Mikkelsen, "Practical Real-Time Hex-Tiling", JCGT 11(2), 2022; the grid is Heitz and Neyret's, "High-Performance By-Example Noise using a Histogram-Preserving Blending Operator", 2018.

/// hex_tile(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(0.5, 9.0, 1.5), vec3f(0.0), vec3f(0.0)), 4.0, 0.5, 1.0, 0u).w == 1.0 +- 1e-3
/// -> Colours are linear Rec. 709. 0..1
fn hex_tile(
    /// What to read.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where.
    position: Place,
    /// Side of one tile. [m] 0.05..1024 = 4.0
    tile: f32,
    /// Distance between copies, in tiles: more keeps large features whole, less hides repetition better. 0.1..4 = 0.5
    spacing: f32,
    /// How far a copy is turned at most: 1 is half a turn either way; 0 keeps directions, as of ripples. 0..1 = 1.0
    turning: f32,
    /// Another seed gives another arrangement. 0..65535 = 0
    seed: u32,
) -> vec4f {
    let grid = hex_tile_grid(position, tile * spacing);
    var sum = vec4f(0.0);
    var total = 0.0;
    for (var corner = 0; corner < 3; corner++) {
        let copy = hex_tile_copy(grid, corner, position, tile, turning, seed);
        let uv = copy.uv;
        let color = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
        let weight = hex_tile_weight(copy.near, color.rgb);
        sum += weight * color;
        total += weight;
    }
    return saturate(sum / max(total, 1e-5));
}

/// Where a point lies on the triangular grid.
struct HexTileGrid {
    /// The cell of the skewed grid.
    cell: vec2i,
    /// Where in it, along x and along the diagonal.
    inside: vec2f,
    /// Distances along x and between rows, in metres.
    steps: vec2f,
}

/// The grid at a place. Rows lie sqrt(3)/2 of the spacing apart and every second one is moved by half of it; both periods
/// are whole units, so cells are exact anywhere.
fn hex_tile_grid(position: Place, spacing: f32) -> HexTileGrid {
    let steps = vec2f(place_periods(vec2f(spacing, spacing * 0.8660254))) / PLACE_UNITS;
    let lattice = place_lattice_xz(position, steps);
    // x - z / 2, with the halves kept in integers.
    let halves = 2 * lattice.cell.x - lattice.cell.y;
    let x = f32(halves & 1) * 0.5 + lattice.fraction.x - 0.5 * lattice.fraction.y;
    let whole = floor(x);
    let cell = vec2i((halves >> 1u) + i32(whole), lattice.cell.y);
    return HexTileGrid(cell, vec2f(x - whole, lattice.fraction.y), steps);
}

/// One of the three copies at a point.
struct HexTileCopy {
    /// For sampling.
    uv: Coord,
    /// Cosine and sine of its turn.
    turn: vec2f,
    /// How near its corner is; the three sum to 1.
    near: f32,
}

/// The copy that belongs to a corner, 0 to 2: turned about it, and shifted by random parts of a tile.
fn hex_tile_copy(grid: HexTileGrid, index: i32, position: Place, tile: f32, turning: f32, seed: u32) -> HexTileCopy {
    let first = vec2i(select(0, 1, grid.inside.x + grid.inside.y > 1.0));
    let corner = select(first, vec2i(2 - index, index - 1), index > 0);
    let away = grid.inside - vec2f(corner);
    // Six-sided distance: barycentric in all three corners.
    let near = saturate(1.0 - max(abs(away.x + away.y), max(abs(away.x), abs(away.y))));
    let way = vec2f(away.x + 0.5 * away.y, away.y) * grid.steps;
    let random = lattice_hash(grid.cell + corner, seed);
    let turn = angle_unit(360.0 * turning * (hash_unit(random.z) - 0.5));
    let matrix = mat2x2f(turn.x, -turn.y, turn.y, turn.x) * (1.0 / tile);
    let uv = matrix * way + hash_unit2(random.xy);
    return HexTileCopy(Coord(uv, matrix * position.ddx.xz, matrix * position.ddy.xz), turn, near);
}

/// Mikkelsen's weight: the 7th power narrows the seams, and brighter copies come through first. Some corner is at least 1/3
/// near, so the sum is at least 0.4 / 3^7.
fn hex_tile_weight(near: f32, color: vec3f) -> f32 {
    let bright = dot(color, vec3f(0.299, 0.587, 0.114));
    let near2 = near * near;
    return mix(1.0, bright, 0.6) * near2 * near2 * near2 * near;
}
