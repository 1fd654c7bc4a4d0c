// dunes: made by Terrane from the graphs. Change those, not this file.
//
// Layers, top to bottom:
//   scrub (graphs/surfaces/scrub.ron): Dry scrub in the hollows, out of the wind.
//   sand (graphs/surfaces/sand.ron): Wind-blown sand: ripples near by, broad changes of colour far away.

/// Below every score, by more than any band.
const LAYER_ABSENT: f32 = -2.0;

/// Score under `height_soft`: w (1 + h), so that a share of 0 stands nowhere. In 0..2.
fn layer_soft_score(share: f32, height: f32) -> f32 {
    return share * (1.0 + saturate(height));
}

/// Weight under `height_soft`, before normalisation: how far the score reaches into the band under the highest, times the share.
///
/// The largest share is at least 1/n, so the highest score m is at least 1/n; a layer that scores m has a share of at least
/// m/2 ≥ 1/(2n) and the weight band · share. The sum of the weights is therefore at least band / (2n), never 0; every weight
/// is continuous in share and height, and 0 where the share is 0.
fn layer_soft_weight(share: f32, score: f32, highest: f32, band: f32) -> f32 {
    return max(score - highest + band, 0.0) * share;
}

/// overlay_f32(0.25, 0.5, 1.0) == 0.25 +- 1e-6
/// overlay_f32(0.25, 1.0, 1.0) == 0.5 +- 1e-6
/// overlay_f32(0.8, 0.25, 0.5) == 0.75 +- 1e-6
/// -> The combined mask. 0..1
fn overlay_f32(
    /// The mask that keeps its shape. 0..1
    base: f32,
    /// The detail to add. 0..1
    detail: f32,
    /// How much of it. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    let dark = 2.0 * base * detail;
    let light = 1.0 - 2.0 * (1.0 - base) * (1.0 - detail);
    return saturate(mix(base, select(light, dark, base < 0.5), opacity));
}

/// Texture coordinates with their screen gradients.
struct Coord {
    /// One unit is one tile.
    uv: vec2f,
    /// Change per pixel to the right.
    ddx: vec2f,
    /// Change per pixel down.
    ddy: vec2f,
}

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

/// Three random words from three words.
fn hash_pcg3d(key: vec3u) -> vec3u {
    var v = key * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// A number from 0 up to but not including 1, from the upper 24 bits: exact in f32.
fn hash_unit(bits: u32) -> f32 {
    return f32(bits >> 8u) * 0.000000059604644775390625;
}

/// A unit vector in any direction, without sine and cosine.
///
/// The half-angle formula (1 - t^2, 2t) / (1 + t^2) runs through 90 degrees as |t| <= tan(22.5 degrees); two more bits turn it by quarters.
fn hash_direction(bits: u32) -> vec2f {
    let t = (f32((bits >> 8u) & 0xffffu) * 0.000030517578125 - 1.0) * 0.41421357;
    let d = vec2f(1.0 - t * t, 2.0 * t) / (1.0 + t * t);
    let turned = select(d, vec2f(-d.y, d.x), (bits & 0x40000000u) != 0u);
    return select(turned, -turned, (bits & 0x80000000u) != 0u);
}

/// lerp_f32(1.5, 0.5, 0.25) == 1.25 +- 1e-6
/// -> Between the two. -1000000..1000000
fn lerp_f32(
    /// What 0 gives. -1000000..1000000
    a: f32,
    /// What 1 gives. -1000000..1000000
    b: f32,
    /// How far on the way. 0..1 = 0.5
    t: f32,
) -> f32 {
    return clamp(mix(a, b, t), min(a, b), max(a, b));
}

/// lerp_vec3(vec3f(1.5, -2.0, 0.25), vec3f(0.5, 4.0, -1.0), 0.25) == vec3f(1.25, -0.5, -0.0625) +- 1e-6
/// -> Between the two. -1000000..1000000
fn lerp_vec3(
    /// What 0 gives. -1000000..1000000
    a: vec3f,
    /// What 1 gives. -1000000..1000000
    b: vec3f,
    /// How far on the way. 0..1 = 0.5
    t: f32,
) -> vec3f {
    return clamp(mix(a, b, t), min(a, b), max(a, b));
}

/// mul_f32(1.5, 0.5) == 0.75 +- 1e-6
/// -> The product. -1000000000000..1000000000000
fn mul_f32(
    /// What to multiply. -1000000..1000000
    a: f32,
    /// How often. -1000000..1000000 = 1.0
    b: f32,
) -> f32 {
    return a * b;
}

/// mul_vec3(vec3f(1.5, -2.0, 0.25), vec3f(0.5, 4.0, -1.0)) == vec3f(0.75, -8.0, -0.25) +- 1e-6
/// -> The product. -1000000000000..1000000000000
fn mul_vec3(
    /// What to multiply. -1000000..1000000
    a: vec3f,
    /// How often. -1000000..1000000 = (1.0, 1.0, 1.0)
    b: vec3f,
) -> vec3f {
    return a * b;
}

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

/// Share of the heights: 1/2 makes the variance at a corner, 1/3 of its square, equal to that in the middle, 1/16 + 1/12 of its square.
const VALUE_GRADIENT_NOISE_HEIGHT: f32 = 0.5;

/// One over the largest sum: sqrt(1/2) of the slopes and 1/2 of the heights.
const VALUE_GRADIENT_NOISE_SCALE: f32 = 0.82842714;

/// The noise at a point of a grid, -1..1, mean 0.
fn value_gradient_noise_at(lattice: Lattice, seed: u32) -> f32 {
    let f = lattice.fraction;
    let fade = lattice_fade(f);
    let a = value_gradient_noise_corner(lattice.cell, vec2i(0, 0), f, seed);
    let b = value_gradient_noise_corner(lattice.cell, vec2i(1, 0), f, seed);
    let c = value_gradient_noise_corner(lattice.cell, vec2i(0, 1), f, seed);
    let d = value_gradient_noise_corner(lattice.cell, vec2i(1, 1), f, seed);
    return VALUE_GRADIENT_NOISE_SCALE * mix(mix(a.x, b.x, fade.x), mix(c.x, d.x, fade.x), fade.y);
}

/// The plane through one corner: its value here, and its slope.
fn value_gradient_noise_corner(cell: vec2i, corner: vec2i, f: vec2f, seed: u32) -> vec3f {
    let random = lattice_hash(cell + corner, seed);
    let slope = hash_direction(random.x);
    let height = VALUE_GRADIENT_NOISE_HEIGHT * (2.0 * hash_unit(random.y) - 1.0);
    return vec3f(height + dot(slope, f - vec2f(corner)), slope);
}

/// planar(Place(vec2i(1024, 0), vec3f(1.0, 9.0, 3.0), vec3f(0.5, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 4.0).uv == vec2f(1.25, 0.75) +- 1e-6
/// planar(Place(vec2i(-1024, 0), vec3f(0.0, 9.0, 0.0), vec3f(0.5, 0.0, 0.0), vec3f(0.0, 0.0, 0.25)), 4.0).ddx == vec2f(0.125, 0.0) +- 1e-6
/// -> For `texture` and its relatives.
fn planar(
    /// Where.
    position: Place,
    /// Side of one tile. [m] 0.01..16384 = 4.0
    tile: f32,
) -> Coord {
    return place_coord(position, tile);
}

/// texture(example_texture, example_sampler, 0, Coord(vec2f(0.125, 0.125), vec2f(0.0), vec2f(0.0))) == vec4f(0.0, 0.0, 0.0, 1.0) +- 0.01
/// texture(example_texture, example_sampler, 0, Coord(vec2f(0.875, 0.375), vec2f(0.0), vec2f(0.0))) == vec4f(1.0, 0.3333333, 0.0, 1.0) +- 0.01
/// -> Colours are linear Rec. 709. 0..1
fn texture(
    /// What to read.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where to read it.
    uv: Coord,
) -> vec4f {
    return textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
}

/// ramp(0.3, 0.2, 0.6) == 0.25 +- 1e-6
/// ramp(0.4, 0.5, 0.35) == 0.6666667 +- 1e-6
/// ramp(800.0, 900.0, 700.0) == 0.5 +- 1e-6
/// ramp(2.0, 2.0, 2.0) == 1.0 +- 0
/// ramp(1.9, 2.0, 2.0) == 0.0 +- 0
/// -> 0 at low and before, 1 at high and beyond. 0..1
fn ramp(
    /// The value that decides. -1000000..1000000
    x: f32,
    /// Where it is still 0. -1000000..1000000 = 0.0
    low: f32,
    /// Where it is 1. -1000000..1000000 = 1.0
    high: f32,
) -> f32 {
    let way = select(high - low, low - high, high < low);
    let gone = select(x - low, low - x, high < low);
    // Held inside the ramp before the division: equal and nearly equal ends give a clean step, never an overflow.
    let inside = clamp(gone, 0.0, way) / max(way, 1.2e-38);
    return select(saturate(inside), 1.0, gone >= way);
}

/// A layer is skipped where its weight is not above this.
const TERRANE_VISIBLE: f32 = 0.001953125f;

/// What the host knows of a place.
struct TerrainIn {
    position: Place,
    slope: f32,
    curvature: f32,
}

/// What may be tweaked while the shader runs.
struct TerrainParameters {
    sand_tint: vec3f,
}

/// What the host is to draw.
struct TerrainOut {
    albedo: vec3f,      // linear Rec. 709
    normal: vec3f,      // tangent space: x east, y south, z out of the ground
    roughness: f32,     // perceptual
    metallic: f32,
    occlusion: f32,     // 1 is open
    emissive: vec3f,
}

/// The look of the ground at one place.
fn terrane_surface(
    terrain: TerrainIn,
    parameters: TerrainParameters,
    color_128x128: texture_2d_array<f32>,
    fine_gray_128x128: texture_2d_array<f32>,
    repeat_linear_1_sampler: sampler,
) -> TerrainOut {
    let scrub_flat = ramp(terrain.slope, 0.2f, 0.05f);
    let scrub_hollow = ramp(terrain.curvature, 0.0f, -0.02f);
    let scrub_patches = fbm(terrain.position, 22.0f, 5u, 0.5f, 0u);
    let scrub_ragged = overlay_f32(scrub_hollow, scrub_patches, 1.0f);
    let scrub_cover = mul_f32(scrub_ragged, scrub_flat);

    var albedo = vec3f(0.0f);
    var roughness = 0.0f;
    var weight = 0.0f;

    // The part of the ground that each layer covers, from the top.
    let scrub_share = saturate(scrub_cover);
    let scrub_under = 1.0f - scrub_share;
    let sand_share = scrub_under;

    var scrub_tufts: f32;
    var scrub_score = LAYER_ABSENT;
    if scrub_share > TERRANE_VISIBLE {
        scrub_tufts = fbm(terrain.position, 1.5f, 3u, 0.5f, 0u);
        scrub_score = layer_soft_score(scrub_share, scrub_tufts);
    }

    var sand_uv: Coord;
    var sand_score = LAYER_ABSENT;
    if sand_share > TERRANE_VISIBLE {
        sand_uv = planar(terrain.position, 3.0f);
        let sand_ripple = texture(fine_gray_128x128, repeat_linear_1_sampler, 0i, sand_uv);
        sand_score = layer_soft_score(sand_share, sand_ripple.x);
    }

    let highest_score = max(sand_score, scrub_score);
    let scrub_weight_raw = layer_soft_weight(scrub_share, scrub_score, highest_score, 0.2f);
    let sand_weight_raw = layer_soft_weight(sand_share, sand_score, highest_score, 0.2f);
    let raw_sum = sand_weight_raw + scrub_weight_raw;
    let scrub_weight = scrub_weight_raw / raw_sum;
    let sand_weight = sand_weight_raw / raw_sum;

    // scrub: graphs/surfaces/scrub.ron
    if scrub_weight > TERRANE_VISIBLE {
        let scrub_color = lerp_vec3(vec3f(0.12f, 0.11f, 0.05f), vec3f(0.3f, 0.27f, 0.13f), scrub_tufts);
        albedo += scrub_weight * scrub_color;
        roughness += scrub_weight * 0.9f;
        weight += scrub_weight;
    }

    // sand: graphs/surfaces/sand.ron
    if sand_weight > TERRANE_VISIBLE {
        let sand_damp = fbm(terrain.position, 70.0f, 3u, 0.5f, 0u);
        let sand_shade = lerp_f32(0.85f, 1.0f, sand_damp);
        let sand_grain = texture(color_128x128, repeat_linear_1_sampler, 0i, sand_uv);
        let sand_warm = mul_vec3(sand_grain.xyz, parameters.sand_tint);
        let sand_color = mul_vec3(sand_warm, vec3f(sand_shade));
        albedo += sand_weight * sand_color;
        roughness += sand_weight * 0.95f;
        weight += sand_weight;
    }

    return TerrainOut(albedo / weight, vec3f(0.0f, 0.0f, 1.0f), roughness / weight, 0.0f, 1.0f, vec3f(0.0f, 0.0f, 0.0f));
}
