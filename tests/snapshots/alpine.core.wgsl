// alpine: made by Terrane from the graphs. Change those, not this file.
//
// Layers, top to bottom:
//   snow (graphs/surfaces/snow.ron): Old snow, packed and cut by the wind; dust on its crests, blue in its hollows.
//   river_bed (graphs/surfaces/river_bed.ron): Rounded stones of a river's bed and banks, wet between the stones.
//   granite (graphs/surfaces/granite.ron): Weathered granite for cliffs: shows on steep ground, breaks along its own cracks.
//   scree (graphs/surfaces/scree.ron): Angular fragments below cliffs, in the colour of the rock that they broke from.
//   conifer_wood (graphs/surfaces/conifer_wood.ron): The roof of a wood of spruce and larch, for woods that are seen from some way off.
//   forest_floor (graphs/surfaces/forest_floor.ron): The floor of a conifer wood: needles, twigs and leaves over dark humus, moss here and there.
//   lush_grass (graphs/surfaces/lush_grass.ron): Green meadow, thick and soft; yellower in patches.
//   dry_grass (graphs/surfaces/dry_grass.ron): Straw-coloured grass of high slopes, grazed and bleached, greener in patches.

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

/// The slopes that a tangent-space normal stands for: what adds up when height fields are blended (partial derivatives).
fn layer_slopes(normal: vec3f) -> vec2f {
    return normal.xy / max(normal.z, 0.001);
}

/// The tangent-space normal of slopes.
fn layer_normal(slopes: vec2f) -> vec3f {
    return normalize(vec3f(slopes, 1.0));
}

/// macro_blend(vec3f(0.4, 0.2, 0.1), 0.5, 0.6) == vec3f(0.4, 0.2, 0.1) +- 1e-6
/// macro_blend(vec3f(0.4, 0.2, 0.1), 1.0, 0.5) == vec3f(0.6, 0.3, 0.15) +- 1e-6
/// macro_blend(vec3f(0.4, 0.2, 0.1), 0.0, 0.5) == vec3f(0.2, 0.1, 0.05) +- 1e-6
/// -> The varied colour. 0..1
fn macro_blend(
    /// The tiled colour. 0..1
    base: vec3f,
    /// The large variation around 0.5, such as `fbm`. 0..1
    variation: f32,
    /// How much brighter and darker it gets. 0..1 = 0.3
    amount: f32,
) -> vec3f {
    return saturate(base * mix(1.0, 2.0 * variation, amount));
}

/// normal_whiteout(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.0, 1.0)) == vec3f(0.6, 0.0, 0.8) +- 1e-5
/// normal_whiteout(vec3f(0.0, 0.0, 1.0), vec3f(0.0, 0.6, 0.8)) == vec3f(0.0, 0.6, 0.8) +- 1e-5
/// normal_whiteout(vec3f(0.6, 0.0, 0.8), vec3f(0.0, 0.6, 0.8)) == vec3f(0.5645324, 0.5645324, 0.6021679) +- 1e-5
/// -> Unit length, z out of the ground. -1..1
fn normal_whiteout(
    /// Of the coarser surface, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    base: vec3f,
    /// Of the detail on it, z out of the ground. -1..1 = (0.0, 0.0, 1.0)
    detail: vec3f,
) -> vec3f {
    let tilt = base.xy + detail.xy;
    return unit_vector_or(vec3f(tilt, base.z * detail.z), vec3f(0.0, 0.0, 1.0));
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

/// screen_f32(0.5, 0.5, 1.0) == 0.75 +- 1e-6
/// screen_f32(0.2, 0.5, 0.5) == 0.4 +- 1e-6
/// screen_f32(0.3, 0.0, 1.0) == 0.3 +- 1e-6
/// -> The combined mask. 0..1
fn screen_f32(
    /// What lies below. 0..1
    base: f32,
    /// What is laid on it. 0..1
    detail: f32,
    /// How much of the blend. 0..1 = 1.0
    opacity: f32,
) -> f32 {
    return saturate(mix(base, base + detail - base * detail, opacity));
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

/// Two such numbers.
fn hash_unit2(bits: vec2u) -> vec2f {
    return vec2f(bits >> vec2u(8u)) * 0.000000059604644775390625;
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

/// normal_from_slope(vec2f(0.75, 0.0), 1.0) == vec3f(-0.6, 0.0, 0.8) +- 1e-5
/// normal_from_slope(vec2f(0.0, 0.1), 7.5) == vec3f(0.0, -0.6, 0.8) +- 1e-5
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn normal_from_slope(
    /// Rise per metre to the east and to the south. [1/m] -1000000..1000000
    slope: vec2f,
    /// Height that a value of 1 stands for. [m] 0..1000 = 1.0
    depth: f32,
) -> vec3f {
    return layer_normal(clamp(-slope * depth, vec2f(-1e6), vec2f(1e6)));
}

/// normal_map(vec4f(0.5, 0.5, 1.0, 1.0), 1.0, 0.0) == vec3f(0.0, 0.0, 1.0) +- 1e-6
/// normal_map(vec4f(0.8, 0.5, 0.9, 1.0), 1.0, 0.0) == vec3f(0.6, 0.0, 0.8) +- 1e-6
/// normal_map(vec4f(0.5, 0.8, 0.9, 1.0), 1.0, 1.0) == vec3f(0.0, -0.6, 0.8) +- 1e-6
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn normal_map(
    /// What the texture gives; red and green are the tilt. 0..1
    texel: vec4f,
    /// Factor on the tilt. 0..4 = 1.0
    strength: f32,
    /// 1 for maps whose green channel points up the image, as OpenGL's do. const 0..1 = 0.0
    flip: f32,
) -> vec3f {
    let n = texel.xyz * 2.0 - 1.0;
    let tilt = n.xy * strength * vec2f(1.0, 1.0 - 2.0 * flip);
    // A texel that points into the ground, or nowhere, is damaged: 0.0625 keeps the result finite and upright.
    return normalize(vec3f(tilt, max(n.z, 0.0625)));
}

/// normal_to_tangent(vec3f(0.6, 0.8, 0.0), vec3f(0.0, 1.0, 0.0)) == vec3f(0.6, 0.0, 0.8) +- 1e-6
/// normal_to_tangent(vec3f(0.48, 0.6, 0.64), vec3f(0.48, 0.6, 0.64)) == vec3f(0.0, 0.0, 1.0) +- 1e-6
/// normal_to_tangent(vec3f(0.96, 0.28, 0.0), vec3f(0.6, 0.8, 0.0)) == vec3f(0.6, 0.0, 0.8) +- 1e-6
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn normal_to_tangent(
    /// In world space, y up. -1..1
    normal: vec3f,
    /// The ground's normal in world space, y up. -1..1 = (0.0, 1.0, 0.0)
    ground: vec3f,
) -> vec3f {
    let n = unit_vector_or(normal, vec3f(0.0, 1.0, 0.0));
    let g = unit_vector_or(ground, vec3f(0.0, 1.0, 0.0));
    let t = vec3f(g.x, 1.0 + g.y, g.z);
    let half_turned = t * (dot(n, t) / max(t.y, 1e-6)) - n;
    return unit_vector_or(vec3f(-half_turned.x, -half_turned.z, half_turned.y), vec3f(0.0, 0.0, 1.0));
}

/// cavity_mask(-0.01, 50.0) == 0.5 +- 1e-6
/// cavity_mask(0.01, 50.0) == 0.0 +- 0
/// -> 1 on hollows as sharp as the radius or sharper. 0..1
fn cavity_mask(
    /// Positive on ridges, negative in hollows. [1/m] -100..100
    curvature: f32,
    /// Radius at which the mask is full. [m] 0.1..10000 = 50.0
    radius: f32,
) -> f32 {
    return saturate(-curvature * radius);
}

/// height_mask(500.0, 300.0, 700.0, 50.0) == 1.0 +- 1e-6
/// height_mask(700.0, 300.0, 700.0, 50.0) == 0.5 +- 1e-6
/// height_mask(100.0, 300.0, 700.0, 50.0) == 0.0 +- 0
/// -> Half way on either border. 0..1
fn height_mask(
    /// Height of the ground. [m] -12000..12000
    height: f32,
    /// Lower border. [m] -12000..12000 = 0.0
    low: f32,
    /// Upper border. [m] -12000..12000 = 1000.0
    high: f32,
    /// Width of a border, half of it outside. [m] 0..4000 = 50.0
    softness: f32,
) -> f32 {
    return between(height, low, high, softness);
}

/// slope_mask(0.5, 30.0, 90.0) == 0.5 +- 1e-3
/// slope_mask(0.0, 30.0, 45.0) == 0.0 +- 0
/// slope_mask(0.0, 20.0, 10.0) == 1.0 +- 0
/// -> 0 at low, 1 at high. 0..1
fn slope_mask(
    /// 1 minus the upward part of the normal: 0 is flat, 1 is a wall. 0..1
    slope: f32,
    /// Angle at which the mask is still 0. [deg] 0..90 = 30.0
    low: f32,
    /// Angle at which it is 1. [deg] 0..90 = 45.0
    high: f32,
) -> f32 {
    // 1 - cos a = 2 sin^2 (a / 2): unlike the arc cosine of something near 1 this keeps its precision on flat ground.
    let half_sine = sqrt(clamp(0.5 * slope, 1e-12, 0.5));
    return ramp_smooth(2.0 * asin(half_sine) * 57.29578, low, high);
}

/// sun_side_mask(vec3f(0.0, 1.0, 0.0), 45.0, 1.0) == 0.5 +- 1e-6
/// sun_side_mask(vec3f(0.0, 0.8, 0.6), 45.0, 1.0) == 0.7828427 +- 1e-5
/// sun_side_mask(vec3f(0.0, 0.8, 0.6), -45.0, 0.5) == 0.2171573 +- 1e-5
/// -> 0.5 on flat ground, more on the sunny side. 0..1
fn sun_side_mask(
    /// The ground's, in world space, y up. -1..1
    normal: vec3f,
    /// North is positive. [deg] -90..90 = 45.0
    latitude: f32,
    /// How quickly the mask leaves 0.5. 0..8 = 1.0
    strength: f32,
) -> f32 {
    let way = angle_unit(latitude);
    let received = normal.y * way.x + normal.z * way.y;
    return saturate(0.5 + strength * (received - way.x));
}

/// add_f32(1.5, 0.5) == 2.0 +- 1e-6
/// -> The sum. -2000000..2000000
fn add_f32(
    /// What to add to. -1000000..1000000
    a: f32,
    /// What to add. -1000000..1000000
    b: f32,
) -> f32 {
    return a + b;
}

/// Cosine and sine of an angle in degrees. Exact at whole quarters, elsewhere within 4e-7 while |degrees| < 100,000.
fn angle_unit(degrees: f32) -> vec2f {
    let quarter = round(degrees / 90.0);
    let x = (degrees - 90.0 * quarter) * 0.017453292;
    let s = x * x;
    let across = x * (1.0 - s * (0.16666667 - s * (0.008333333 - s * (0.0001984127 - s * 0.0000027557319))));
    let along = 1.0 - s * (0.5 - s * (0.041666668 - s * (0.0013888889 - s * 0.000024801588)));
    let turn = i32(quarter) & 3;
    let odd = select(vec2f(along, across), vec2f(-across, along), (turn & 1) != 0);
    return clamp(select(odd, -odd, turn >= 2), vec2f(-1.0), vec2f(1.0));
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

/// one_minus_f32(1.5) == -0.5 +- 1e-6
/// -> The complement. -1000000..1000001
fn one_minus_f32(
    /// The value. -1000000..1000000
    x: f32,
) -> f32 {
    return 1.0 - x;
}

/// sub_f32(1.5, 0.5) == 1.0 +- 1e-6
/// -> The difference. -2000000..2000000
fn sub_f32(
    /// What to take from. -1000000..1000000
    a: f32,
    /// What to take away. -1000000..1000000
    b: f32,
) -> f32 {
    return a - b;
}

/// The direction of `v`, or `otherwise` where every component is under 1e-18. Components up to 1e18 do no harm.
///
/// Scaled by the largest component first: the square of a small one would vanish.
fn unit_vector_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let a = abs(v);
    let largest = max(a.x, max(a.y, a.z));
    let scaled = v / max(largest, 1e-18);
    let usable = largest >= 1e-18;
    let direction = normalize(select(vec3f(0.0, 1.0, 0.0), scaled, usable));
    return select(otherwise, clamp(direction, vec3f(-1.0), vec3f(1.0)), usable);
}

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

/// The noise, and its change per cell along x and z.
fn value_gradient_noise_slope_at(lattice: Lattice, seed: u32) -> vec3f {
    let f = lattice.fraction;
    let fade = lattice_fade(f);
    let rise = lattice_fade_slope(f);
    let a = value_gradient_noise_corner(lattice.cell, vec2i(0, 0), f, seed);
    let b = value_gradient_noise_corner(lattice.cell, vec2i(1, 0), f, seed);
    let c = value_gradient_noise_corner(lattice.cell, vec2i(0, 1), f, seed);
    let d = value_gradient_noise_corner(lattice.cell, vec2i(1, 1), f, seed);
    let north = mix(a, b, fade.x);
    let south = mix(c, d, fade.x);
    let bend = rise * vec2f(mix(b.x - a.x, d.x - c.x, fade.y), south.x - north.x);
    return VALUE_GRADIENT_NOISE_SCALE * (mix(north, south, fade.y) + vec3f(0.0, bend));
}

/// The plane through one corner: its value here, and its slope.
fn value_gradient_noise_corner(cell: vec2i, corner: vec2i, f: vec2f, seed: u32) -> vec3f {
    let random = lattice_hash(cell + corner, seed);
    let slope = hash_direction(random.x);
    let height = VALUE_GRADIENT_NOISE_HEIGHT * (2.0 * hash_unit(random.y) - 1.0);
    return vec3f(height + dot(slope, f - vec2f(corner)), slope);
}

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

/// hex_tile_normal(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(0.5, 9.0, 1.5), vec3f(0.0), vec3f(0.0)), 4.0, 0.5, 1.0, 0u, 0.0) == vec3f(0.0, 0.0, 1.0) +- 1e-6
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn hex_tile_normal(
    /// A normal map whose green channel points down the image.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where.
    position: Place,
    /// Side of one tile. [m] 0.05..1024 = 4.0
    tile: f32,
    /// Distance between copies, in tiles: as for the colour. 0.1..4 = 0.5
    spacing: f32,
    /// How far a copy is turned at most: as for the colour. 0..1 = 1.0
    turning: f32,
    /// Another seed gives another arrangement: as for the colour. 0..65535 = 0
    seed: u32,
    /// Factor on the tilt. 0..4 = 1.0
    strength: f32,
) -> vec3f {
    let grid = hex_tile_grid(position, tile * spacing);
    var tilt = vec2f(0.0);
    var total = 0.0;
    for (var corner = 0; corner < 3; corner++) {
        let copy = hex_tile_copy(grid, corner, position, tile, turning, seed);
        let uv = copy.uv;
        let texel = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
        let weight = hex_tile_weight(copy.near, vec3f(1.0));
        let turned = layer_slopes(normal_map(texel, strength, 0.0));
        let back = mat2x2f(copy.turn.x, copy.turn.y, -copy.turn.y, copy.turn.x);
        tilt += weight * (back * turned);
        total += weight;
    }
    return layer_normal(tilt / max(total, 1e-5));
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

/// triplanar(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(0.5, 9.0, 1.5), vec3f(0.0), vec3f(0.0)), vec3f(0.0, 1.0, 0.0), 4.0, 4.0) == vec4f(0.0, 0.3333333, 1.0, 1.0) +- 0.01
/// triplanar(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(9.0, -1.5, 3.5), vec3f(0.0), vec3f(0.0)), vec3f(1.0, 0.0, 0.0), 4.0, 4.0) == vec4f(1.0, 0.3333333, 0.0, 1.0) +- 0.01
/// -> Colours are linear Rec. 709. 0..1
fn triplanar(
    /// What to read.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where.
    position: Place,
    /// The ground's, in world space, y up. -1..1
    normal: vec3f,
    /// Side of one tile. [m] 0.01..16384 = 4.0
    tile: f32,
    /// How quickly one side hands over to the next. 1..16 = 4.0
    sharpness: f32,
) -> vec4f {
    let weights = triplanar_weights(normal, sharpness);
    var color = vec4f(0.0);
    if (weights.x > 0.0) {
        let uv = triplanar_east(position, tile);
        color += weights.x * textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
    }
    if (weights.y > 0.0) {
        let uv = place_coord(position, tile);
        color += weights.y * textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
    }
    if (weights.z > 0.0) {
        let uv = triplanar_south(position, tile);
        color += weights.z * textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
    }
    return saturate(color);
}

/// How much the views along x, y and z count; they sum to 1.
///
/// The largest component is scaled to 1 before the power, so the sum is at least 1 - 1/64; a normal of 0 counts as upright.
fn triplanar_weights(normal: vec3f, sharpness: f32) -> vec3f {
    let a = abs(normal);
    let largest = max(a.x, max(a.y, a.z));
    let scaled = select(vec3f(0.0, 1.0, 0.0), a / max(largest, 1e-6), largest > 1e-6);
    let powered = pow(max(scaled, vec3f(1e-3)), vec3f(sharpness));
    let kept = max(powered - 0.015625, vec3f(0.0));
    return kept / (kept.x + kept.y + kept.z);
}

/// Seen along x: u runs south, v down.
fn triplanar_east(position: Place, tile: f32) -> Coord {
    let uv = place_coord(position, tile);
    let rise = vec3f(position.local.y, position.ddx.y, position.ddy.y) / tile;
    return Coord(vec2f(uv.uv.y, -rise.x), vec2f(uv.ddx.y, -rise.y), vec2f(uv.ddy.y, -rise.z));
}

/// Seen along z: u runs east, v down.
fn triplanar_south(position: Place, tile: f32) -> Coord {
    let uv = place_coord(position, tile);
    let rise = vec3f(position.local.y, position.ddx.y, position.ddy.y) / tile;
    return Coord(vec2f(uv.uv.x, -rise.x), vec2f(uv.ddx.x, -rise.y), vec2f(uv.ddy.x, -rise.z));
}

/// triplanar_normal(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(0.5, 9.0, 1.5), vec3f(0.0), vec3f(0.0)), vec3f(0.0, 1.0, 0.0), 4.0, 4.0, 0.0) == vec3f(0.0, 0.0, 1.0) +- 1e-5
/// triplanar_normal(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(0.5, 9.0, 1.5), vec3f(0.0), vec3f(0.0)), vec3f(0.0, 1.0, 0.0), 4.0, 4.0, 1.0) == vec3f(-0.6882472, -0.2294157, 0.6882472) +- 0.01
/// -> Unit length, relative to the ground; x east, y south, z out of it. -1..1
fn triplanar_normal(
    /// A normal map whose green channel points down the image.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where.
    position: Place,
    /// The ground's, in world space, y up. -1..1
    normal: vec3f,
    /// Side of one tile. [m] 0.01..16384 = 4.0
    tile: f32,
    /// How quickly one side hands over to the next. 1..16 = 4.0
    sharpness: f32,
    /// Factor on the tilt. 0..4 = 1.0
    strength: f32,
) -> vec3f {
    let weights = triplanar_weights(normal, sharpness);
    // Each view tilts the ground's normal in its own plane; the component along the view stays.
    var bent = vec3f(0.0);
    if (weights.x > 0.0) {
        let uv = triplanar_east(position, tile);
        let texel = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
        let n = normal_map(texel, strength, 0.0);
        bent += weights.x * vec3f(n.z * normal.x, normal.y - n.y, normal.z + n.x);
    }
    if (weights.y > 0.0) {
        let uv = place_coord(position, tile);
        let texel = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
        let n = normal_map(texel, strength, 0.0);
        bent += weights.y * vec3f(normal.x + n.x, n.z * normal.y, normal.z + n.y);
    }
    if (weights.z > 0.0) {
        let uv = triplanar_south(position, tile);
        let texel = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
        let n = normal_map(texel, strength, 0.0);
        bent += weights.z * vec3f(normal.x + n.x, normal.y - n.y, n.z * normal.z);
    }
    return normal_to_tangent(bent, normal);
}

/// luminance(vec3f(1.0, 1.0, 1.0)) == 1.0 +- 1e-6
/// luminance(vec3f(0.5, 0.25, 1.0)) == 0.3573 +- 1e-6
/// -> Relative luminance. 0..1000
fn luminance(
    /// Linear Rec. 709. 0..1000
    color: vec3f,
) -> f32 {
    return min(dot(color, vec3f(0.2126, 0.7152, 0.0722)), 1000.0);
}

/// occlusion_from_height(1.0, 0.6) == 1.0 +- 0
/// occlusion_from_height(0.0, 0.6) == 0.4 +- 1e-6
/// occlusion_from_height(0.5, 0.6) == 0.85 +- 1e-6
/// -> 1 is open, 0 is closed. 0..1
fn occlusion_from_height(
    /// Of the material's own relief. 0..1
    height: f32,
    /// How dark the deepest parts get. 0..1 = 0.6
    amount: f32,
) -> f32 {
    let deep = 1.0 - height;
    return saturate(1.0 - amount * deep * deep);
}

/// roughness_from_height(0.25, 1.0, 1.0, 0.4, 0.8) == 0.7 +- 1e-5
/// roughness_from_height(0.5, 0.0, 2.0, 0.0, 1.0) == 0.25 +- 1e-5
/// -> Perceptual roughness. 0..1
fn roughness_from_height(
    /// Of the material's own relief. 0..1
    height: f32,
    /// 1 makes deep parts the rougher ones, 0 the high ones. 0..1 = 1.0
    inversion: f32,
    /// More than 1 keeps roughness to the extreme parts. 0.1..16 = 1.0
    exponent: f32,
    /// Roughness of the smoothest parts. 0..1 = 0.5
    low: f32,
    /// Roughness of the roughest parts. 0..1 = 1.0
    high: f32,
) -> f32 {
    return saturate(mix(low, high, specular_from_color_term(height, inversion, exponent)));
}

/// Inversion and power of a value 0..1.
fn specular_from_color_term(x: f32, inversion: f32, exponent: f32) -> f32 {
    let t = saturate(mix(x, 1.0 - x, inversion));
    return select(saturate(pow(max(t, 1e-20), exponent)), 0.0, t <= 0.0);
}

/// tint(vec3f(0.5, 0.5, 0.5), vec3f(0.4, 0.5, 0.2), 0.0) == vec3f(0.5, 0.5, 0.5) +- 1e-6
/// tint(vec3f(0.2, 0.2, 0.2), vec3f(0.4, 0.5, 0.2), 1.0) == vec3f(0.1750241, 0.2187801, 0.0875120) +- 1e-5
/// tint(vec3f(0.2, 0.2, 0.2), vec3f(0.0, 0.0, 0.0), 1.0) == vec3f(0.2, 0.2, 0.2) +- 1e-5
/// -> Linear Rec. 709, held at 1. 0..1
fn tint(
    /// Linear Rec. 709. 0..1
    color: vec3f,
    /// The colour to take on; its brightness does not matter, black does nothing. 0..1
    toward: vec3f,
    /// How much of it. 0..1 = 1.0
    amount: f32,
) -> vec3f {
    let bright = luminance(toward);
    let scaled = select(color, toward * (luminance(color) / max(bright, 1e-4)), bright > 1e-4);
    return saturate(mix(color, min(scaled, vec3f(1e4)), amount));
}

/// What water leaves of a material.
struct Wet {
    /// Darker where it soaks. 0..1
    albedo: vec3f,
    /// Smoother. 0..1
    roughness: f32,
}

/// wet(vec3f(0.5, 0.4, 0.3), 0.9, 0.0).albedo == vec3f(0.5, 0.4, 0.3) +- 1e-6
/// wet(vec3f(0.5, 0.4, 0.3), 0.9, 1.0).albedo == vec3f(0.1, 0.08, 0.06) +- 1e-5
/// wet(vec3f(0.5, 0.4, 0.3), 0.9, 1.0).roughness == 0.54 +- 1e-5
/// wet(vec3f(0.5, 0.4, 0.3), 0.5, 1.0).albedo == vec3f(0.5, 0.4, 0.3) +- 1e-5
fn wet(
    /// Of the dry material, linear Rec. 709. 0..1
    albedo: vec3f,
    /// Of the dry material; from 0.5 on it counts as porous, from 0.9 as sponge. 0..1 = 0.9
    roughness: f32,
    /// 0 is dry, 1 is soaked. 0..1 = 0.5
    amount: f32,
) -> Wet {
    let porous = saturate((roughness - 0.5) / 0.4);
    let factor = mix(1.0, 0.2, porous);
    let smoothed = mix(1.0, factor, 0.5 * amount);
    return Wet(saturate(albedo * mix(1.0, factor, amount)), saturate(roughness * smoothed));
}

/// between(5.0, 2.0, 8.0, 2.0) == 1.0 +- 1e-6
/// between(2.0, 2.0, 8.0, 2.0) == 0.5 +- 1e-6
/// between(8.5, 2.0, 8.0, 2.0) == 0.15625 +- 1e-6
/// between(9.0, 2.0, 8.0, 0.0) == 0.0 +- 0
/// -> Half way on either border. 0..1
fn between(
    /// The value that decides. -1000000..1000000
    x: f32,
    /// Lower border. -1000000..1000000 = 0.0
    low: f32,
    /// Upper border. -1000000..1000000 = 1.0
    high: f32,
    /// Width of a border, half of it outside. 0..1000000 = 0.1
    softness: f32,
) -> f32 {
    let reach = 0.5 * softness;
    let above = ramp_smooth(x, low - reach, low + reach);
    return saturate(above * (1.0 - ramp_smooth(x, high - reach, high + reach)));
}

/// contrast(0.6, 2.0) == 0.7 +- 1e-6
/// contrast(0.1, 4.0) == 0.0 +- 0
/// -> 0.5 stays 0.5. 0..1
fn contrast(
    /// The value to spread. 0..1
    x: f32,
    /// 1 changes nothing, 0 makes everything grey, more is crisper. 0..64 = 2.0
    amount: f32,
) -> f32 {
    return saturate((x - 0.5) * amount + 0.5);
}

/// levels(0.5, 0.2, 0.8, 1.0) == 0.5 +- 1e-6
/// levels(0.5, 0.0, 1.0, 2.0) == 0.70710678 +- 1e-5
/// levels(0.1, 0.2, 0.8, 2.0) == 0.0 +- 0
/// -> 0 at black, 1 at white. 0..1
fn levels(
    /// The value to correct. 0..1
    x: f32,
    /// What becomes 0. 0..1 = 0.0
    black: f32,
    /// What becomes 1. 0..1 = 1.0
    white: f32,
    /// More than 1 brightens the middle. 0.1..10 = 1.0
    gamma: f32,
) -> f32 {
    let t = ramp(x, black, white);
    let bent = pow(max(t, 1e-20), 1.0 / max(gamma, 0.1));
    return select(saturate(bent), 0.0, t <= 0.0);
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

/// ramp_smooth(0.3, 0.2, 0.6) == 0.15625 +- 1e-6
/// ramp_smooth(0.3, 0.6, 0.2) == 0.84375 +- 1e-6
/// ramp_smooth(5.0, 5.0, 5.0) == 1.0 +- 0
/// -> 0 at low and before, 1 at high and beyond. 0..1
fn ramp_smooth(
    /// The value that decides. -1000000..1000000
    x: f32,
    /// Where it is still 0. -1000000..1000000 = 0.0
    low: f32,
    /// Where it is 1. -1000000..1000000 = 1.0
    high: f32,
) -> f32 {
    let t = ramp(x, low, high);
    return saturate(t * t * (3.0 - 2.0 * t));
}

/// remap(15.0, 10.0, 20.0, 0.0, 4.0) == 2.0 +- 1e-6
/// remap(25.0, 10.0, 20.0, 4.0, 1.0) == 1.0 +- 1e-6
/// -> Between the two ends of the new range. -1000000..1000000
fn remap(
    /// The value to carry over. -1000000..1000000
    x: f32,
    /// Start of the old range. -1000000..1000000 = 0.0
    from_low: f32,
    /// End of the old range. -1000000..1000000 = 1.0
    from_high: f32,
    /// What the start becomes. -1000000..1000000 = 0.0
    to_low: f32,
    /// What the end becomes. -1000000..1000000 = 1.0
    to_high: f32,
) -> f32 {
    let carried = mix(to_low, to_high, ramp(x, from_low, from_high));
    return clamp(carried, min(to_low, to_high), max(to_low, to_high));
}

/// A layer is skipped where its weight is not above this.
const TERRANE_VISIBLE: f32 = 0.001953125f;

/// What the host knows of a place.
struct TerrainIn {
    position: Place,
    terrain_uv: Coord,
    height: f32,
    slope: f32,
    normal: vec3f,
    curvature: f32,
}

/// What may be tweaked while the shader runs.
struct TerrainParameters {
    dry_grass_hue: vec3f,
    dry_grass_tile: f32,
    dry_grass_tint: vec3f,
    meadow_top: f32,
    lush_grass_hue: vec3f,
    lush_grass_tile: f32,
    lush_grass_tint: vec3f,
    wood_floor_groves: f32,
    wood_floor_line: f32,
    forest_floor_moss: vec3f,
    forest_floor_tile: f32,
    forest_floor_tint: vec3f,
    tree_line_groves: f32,
    tree_line_line: f32,
    conifer_wood_larch: vec3f,
    conifer_wood_spacing: f32,
    conifer_wood_spruce: vec3f,
    conifer_wood_tall: f32,
    scree_hue: vec3f,
    scree_tile: f32,
    scree_tint: vec3f,
    granite_gentle: f32,
    granite_steep: f32,
    granite_tile: f32,
    granite_tint: vec3f,
    river_source: f32,
    river_stream: f32,
    river_bed_tile: f32,
    river_bed_wetness: f32,
    snow_line_line: f32,
    snow_line_shade: f32,
    snow_tile: f32,
    snow_turning: f32,
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
    color_1024x1024: texture_2d_array<f32>,
    fine_data_1024x1024: texture_2d_array<f32>,
    data_1024x1024: texture_2d_array<f32>,
    gray_2048x2048: texture_2d_array<f32>,
    repeat_linear_4_sampler: sampler,
    clamp_linear_1_sampler: sampler,
) -> TerrainOut {
    let dry_grass_varied_broad = fbm(terrain.position, 170.0f, 5u, 0.55f, 21u);
    let dry_grass_varied_patch = levels(dry_grass_varied_broad, 0.42f, 0.68f, 1.0f);
    let dry_grass_varied_small = fbm(terrain.position, 23.0f, 4u, 0.5f, 22u);
    let dry_grass_varied_wide = contrast(dry_grass_varied_small, 2.2f);
    let meadow_gentle = slope_mask(terrain.slope, 36.0f, 22.0f);
    let meadow_patch = fbm(terrain.position, 120.0f, 6u, 0.6f, 81u);
    let meadow_runs = texture(gray_2048x2048, clamp_linear_1_sampler, 0i, terrain.terrain_uv);
    let meadow_moist = ramp_smooth(meadow_runs.x, 0.05f, 0.4f);
    let meadow_wander = remap(meadow_patch, 0.25f, 0.75f, 150.0f, -150.0f);
    let meadow_ragged = add_f32(terrain.height, meadow_wander);
    let meadow_under_top = sub_f32(parameters.meadow_top, meadow_ragged);
    let meadow_low = ramp_smooth(meadow_under_top, -60.0f, 120.0f);
    let meadow_fed = screen_f32(meadow_low, meadow_moist, 0.5f);
    let meadow_green = mul_f32(meadow_fed, meadow_gentle);
    let meadow_grassy_grain = contrast(meadow_patch, 4.0f);
    let meadow_grassy_edge = overlay_f32(meadow_green, meadow_grassy_grain, 1.0f);
    let lush_grass_varied_amount = mul_f32(dry_grass_varied_patch, 0.35f);
    let wood_floor_bare = one_minus_f32(parameters.wood_floor_groves);
    let wood_floor_dense = add_f32(wood_floor_bare, 0.05f);
    let wood_floor_holds = slope_mask(terrain.slope, 44.0f, 37.0f);
    let wood_floor_patch = fbm(terrain.position, 260.0f, 6u, 0.55f, 71u);
    let wood_floor_grove = ramp_smooth(wood_floor_patch, wood_floor_bare, wood_floor_dense);
    let wood_floor_wander = remap(wood_floor_patch, 0.25f, 0.75f, 90.0f, -90.0f);
    let wood_floor_ragged = add_f32(terrain.height, wood_floor_wander);
    let wood_floor_below_line = sub_f32(parameters.wood_floor_line, wood_floor_ragged);
    let wood_floor_low = ramp_smooth(wood_floor_below_line, 0.0f, 60.0f);
    let wood_floor_wooded = mul_f32(wood_floor_low, wood_floor_grove);
    let wood_floor_rooted = mul_f32(wood_floor_wooded, wood_floor_holds);
    let tree_line_bare = one_minus_f32(parameters.tree_line_groves);
    let tree_line_dense = add_f32(tree_line_bare, 0.05f);
    let tree_line_grove = ramp_smooth(wood_floor_patch, tree_line_bare, tree_line_dense);
    let tree_line_below_line = sub_f32(parameters.tree_line_line, wood_floor_ragged);
    let tree_line_low = ramp_smooth(tree_line_below_line, 0.0f, 60.0f);
    let tree_line_wooded = mul_f32(tree_line_low, tree_line_grove);
    let tree_line_rooted = mul_f32(tree_line_wooded, wood_floor_holds);
    let talus_high = height_mask(terrain.height, 1500.0f, 4000.0f, 240.0f);
    let talus_loose = texture(gray_2048x2048, clamp_linear_1_sampler, 1i, terrain.terrain_uv);
    let talus_deep = ramp_smooth(talus_loose.x, 0.25f, 0.7f);
    let talus_patch = fbm(terrain.position, 70.0f, 6u, 0.6f, 101u);
    let talus_steep = slope_mask(terrain.slope, 24.0f, 31.0f);
    let talus_raw = mul_f32(talus_steep, talus_high);
    let talus_some_grain = contrast(talus_patch, 4.0f);
    let talus_some_edge = overlay_f32(talus_raw, talus_some_grain, 1.0f);
    let talus_fallen = screen_f32(talus_some_edge, talus_deep, 1.0f);
    let granite_cliffs = slope_mask(terrain.slope, parameters.granite_gentle, parameters.granite_steep);
    let granite_ragged = fbm(terrain.position, 40.0f, 6u, 0.6f, 31u);
    let granite_stone_near_height = triplanar(fine_data_1024x1024, repeat_linear_4_sampler, 4i, terrain.position, terrain.normal, parameters.granite_tile, 4.0f);
    let granite_torn_grain = contrast(granite_ragged, 5.0f);
    let granite_torn_edge = overlay_f32(granite_cliffs, granite_torn_grain, 1.0f);
    let granite_edge_grain = contrast(granite_stone_near_height.x, 2.0f);
    let granite_edge_edge = overlay_f32(granite_torn_edge, granite_edge_grain, 1.0f);
    let river_grain = fbm(terrain.position, 4.0f, 4u, 0.6f, 91u);
    let river_bed = ramp_smooth(meadow_runs.x, parameters.river_source, parameters.river_stream);
    let river_banks_grain = contrast(river_grain, 3.0f);
    let river_banks_edge = overlay_f32(river_bed, river_banks_grain, 1.0f);
    let snow_line_hollow = cavity_mask(terrain.curvature, 60.0f);
    let snow_line_drift = mul_f32(snow_line_hollow, 90.0f);
    let snow_line_lies = slope_mask(terrain.slope, 50.0f, 38.0f);
    let snow_line_ragged = fbm(terrain.position, 160.0f, 6u, 0.6f, 61u);
    let snow_line_sunny = sun_side_mask(terrain.normal, 46.0f, 1.5f);
    let snow_line_sun_lift = remap(snow_line_sunny, 0.0f, 1.0f, 0.5f, -0.5f);
    let snow_line_lift = mul_f32(snow_line_sun_lift, parameters.snow_line_shade);
    let snow_line_wander = remap(snow_line_ragged, 0.25f, 0.75f, -110.0f, 110.0f);
    let snow_line_wandered = add_f32(terrain.height, snow_line_wander);
    let snow_line_shaded = add_f32(snow_line_wandered, snow_line_lift);
    let snow_line_sheltered = add_f32(snow_line_shaded, snow_line_drift);
    let snow_line_above_line = sub_f32(snow_line_sheltered, parameters.snow_line_line);
    let snow_line_high = ramp_smooth(snow_line_above_line, -25.0f, 45.0f);
    let snow_line_lasting = mul_f32(snow_line_high, snow_line_lies);

    var albedo = vec3f(0.0f);
    var slopes = vec2f(0.0f);
    var roughness = 0.0f;
    var occlusion = 0.0f;
    var weight = 0.0f;

    // The part of the ground that each layer covers, from the top.
    let snow_share = saturate(snow_line_lasting);
    let snow_under = 1.0f - snow_share;
    let river_bed_share = snow_under * saturate(river_banks_edge);
    let river_bed_under = snow_under - river_bed_share;
    let granite_share = river_bed_under * saturate(granite_edge_edge);
    let granite_under = river_bed_under - granite_share;
    let scree_share = granite_under * saturate(talus_fallen);
    let scree_under = granite_under - scree_share;
    let conifer_wood_share = scree_under * saturate(tree_line_rooted);
    let conifer_wood_under = scree_under - conifer_wood_share;
    let forest_floor_share = conifer_wood_under * saturate(wood_floor_rooted);
    let forest_floor_under = conifer_wood_under - forest_floor_share;
    let lush_grass_share = forest_floor_under * saturate(meadow_grassy_edge);
    let lush_grass_under = forest_floor_under - lush_grass_share;
    let dry_grass_share = lush_grass_under;

    var snow_ground_near_height: vec4f;
    var snow_score = LAYER_ABSENT;
    if snow_share > TERRANE_VISIBLE {
        snow_ground_near_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 6i, terrain.position, parameters.snow_tile, 0.7f, parameters.snow_turning, 0u);
        snow_score = layer_soft_score(snow_share, snow_ground_near_height.x);
    }

    var river_bed_ground_near_height: vec4f;
    var river_bed_score = LAYER_ABSENT;
    if river_bed_share > TERRANE_VISIBLE {
        river_bed_ground_near_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 5i, terrain.position, parameters.river_bed_tile, 0.7f, 1.0f, 0u);
        river_bed_score = layer_soft_score(river_bed_share, river_bed_ground_near_height.x);
    }
    let granite_score = layer_soft_score(granite_share, granite_stone_near_height.x);

    var scree_ground_near_height: vec4f;
    var scree_score = LAYER_ABSENT;
    if scree_share > TERRANE_VISIBLE {
        scree_ground_near_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 3i, terrain.position, parameters.scree_tile, 0.7f, 1.0f, 0u);
        scree_score = layer_soft_score(scree_share, scree_ground_near_height.x);
    }

    var conifer_wood_trees: Crowns;
    var conifer_wood_score = LAYER_ABSENT;
    if conifer_wood_share > TERRANE_VISIBLE {
        let conifer_wood_stand = warp(terrain.position, 14.0f, 3.5f, 2u, 152u);
        conifer_wood_trees = crowns(conifer_wood_stand, parameters.conifer_wood_spacing, 0.8f, 0.55f, 1.0f, 151u);
        conifer_wood_score = layer_soft_score(conifer_wood_share, conifer_wood_trees.height);
    }

    var forest_floor_ground_near_height: vec4f;
    var forest_floor_score = LAYER_ABSENT;
    if forest_floor_share > TERRANE_VISIBLE {
        forest_floor_ground_near_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 2i, terrain.position, parameters.forest_floor_tile, 0.7f, 1.0f, 0u);
        forest_floor_score = layer_soft_score(forest_floor_share, forest_floor_ground_near_height.x);
    }

    var lush_grass_ground_near_height: vec4f;
    var lush_grass_score = LAYER_ABSENT;
    if lush_grass_share > TERRANE_VISIBLE {
        lush_grass_ground_near_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 1i, terrain.position, parameters.lush_grass_tile, 0.7f, 1.0f, 0u);
        lush_grass_score = layer_soft_score(lush_grass_share, lush_grass_ground_near_height.x);
    }

    var dry_grass_ground_near_height: vec4f;
    var dry_grass_score = LAYER_ABSENT;
    if dry_grass_share > TERRANE_VISIBLE {
        dry_grass_ground_near_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 0i, terrain.position, parameters.dry_grass_tile, 0.7f, 1.0f, 0u);
        dry_grass_score = layer_soft_score(dry_grass_share, dry_grass_ground_near_height.x);
    }

    let highest_score = max(max(max(max(max(max(max(dry_grass_score, lush_grass_score), forest_floor_score), conifer_wood_score), scree_score), granite_score), river_bed_score), snow_score);
    let snow_weight_raw = layer_soft_weight(snow_share, snow_score, highest_score, 0.2f);
    let river_bed_weight_raw = layer_soft_weight(river_bed_share, river_bed_score, highest_score, 0.2f);
    let granite_weight_raw = layer_soft_weight(granite_share, granite_score, highest_score, 0.2f);
    let scree_weight_raw = layer_soft_weight(scree_share, scree_score, highest_score, 0.2f);
    let conifer_wood_weight_raw = layer_soft_weight(conifer_wood_share, conifer_wood_score, highest_score, 0.2f);
    let forest_floor_weight_raw = layer_soft_weight(forest_floor_share, forest_floor_score, highest_score, 0.2f);
    let lush_grass_weight_raw = layer_soft_weight(lush_grass_share, lush_grass_score, highest_score, 0.2f);
    let dry_grass_weight_raw = layer_soft_weight(dry_grass_share, dry_grass_score, highest_score, 0.2f);
    let raw_sum = dry_grass_weight_raw + lush_grass_weight_raw + forest_floor_weight_raw + conifer_wood_weight_raw + scree_weight_raw + granite_weight_raw + river_bed_weight_raw + snow_weight_raw;
    let snow_weight = snow_weight_raw / raw_sum;
    let river_bed_weight = river_bed_weight_raw / raw_sum;
    let granite_weight = granite_weight_raw / raw_sum;
    let scree_weight = scree_weight_raw / raw_sum;
    let conifer_wood_weight = conifer_wood_weight_raw / raw_sum;
    let forest_floor_weight = forest_floor_weight_raw / raw_sum;
    let lush_grass_weight = lush_grass_weight_raw / raw_sum;
    let dry_grass_weight = dry_grass_weight_raw / raw_sum;

    // snow: graphs/surfaces/snow.ron
    if snow_weight > TERRANE_VISIBLE {
        let snow_ground_far_tile = mul_f32(parameters.snow_tile, 5.1f);
        let snow_ground_far_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 6i, terrain.position, snow_ground_far_tile, 0.7f, parameters.snow_turning, 17u);
        let snow_ground_far_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 6i, terrain.position, snow_ground_far_tile, 0.7f, parameters.snow_turning, 17u, 0.45f);
        let snow_ground_near_color = hex_tile(color_1024x1024, repeat_linear_4_sampler, 6i, terrain.position, parameters.snow_tile, 0.7f, parameters.snow_turning, 0u);
        let snow_ground_mottled = macro_blend(snow_ground_near_color.xyz, snow_ground_far_height.x, 0.05f);
        let snow_ground_near_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 6i, terrain.position, parameters.snow_tile, 0.7f, parameters.snow_turning, 0u, 1.0f);
        let snow_ground_bent = normal_whiteout(snow_ground_far_normal, snow_ground_near_normal);
        let snow_varied_amount = mul_f32(dry_grass_varied_patch, 0.2f);
        let snow_varied_hued = tint(snow_ground_mottled, vec3f(0.75f, 0.8f, 0.9f), snow_varied_amount);
        let snow_varied_varied = macro_blend(snow_varied_hued, dry_grass_varied_wide, 0.04f);
        let snow_shaded_clean = occlusion_from_height(snow_ground_near_height.x, 0.03f);
        let snow_shaded_open = occlusion_from_height(snow_ground_near_height.x, 0.25f);
        let snow_shaded_soiled = mul_vec3(snow_varied_varied, vec3f(snow_shaded_clean));
        albedo += snow_weight * snow_shaded_soiled;
        slopes += snow_weight * layer_slopes(snow_ground_bent);
        roughness += snow_weight * 0.82f;
        occlusion += snow_weight * snow_shaded_open;
        weight += snow_weight;
    }

    // river_bed: graphs/surfaces/river_bed.ron
    if river_bed_weight > TERRANE_VISIBLE {
        let river_bed_ground_far_tile = mul_f32(parameters.river_bed_tile, 6.7f);
        let river_bed_ground_far_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 5i, terrain.position, river_bed_ground_far_tile, 0.7f, 1.0f, 17u);
        let river_bed_ground_far_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 5i, terrain.position, river_bed_ground_far_tile, 0.7f, 1.0f, 17u, 0.495f);
        let river_bed_ground_near_color = hex_tile(color_1024x1024, repeat_linear_4_sampler, 5i, terrain.position, parameters.river_bed_tile, 0.7f, 1.0f, 0u);
        let river_bed_ground_mottled = macro_blend(river_bed_ground_near_color.xyz, river_bed_ground_far_height.x, 0.35f);
        let river_bed_ground_near_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 5i, terrain.position, parameters.river_bed_tile, 0.7f, 1.0f, 0u, 1.1f);
        let river_bed_ground_bent = normal_whiteout(river_bed_ground_far_normal, river_bed_ground_near_normal);
        let river_bed_varied_amount = mul_f32(dry_grass_varied_patch, 0.3f);
        let river_bed_varied_hued = tint(river_bed_ground_mottled, vec3f(0.45f, 0.4f, 0.3f), river_bed_varied_amount);
        let river_bed_varied_varied = macro_blend(river_bed_varied_hued, dry_grass_varied_wide, 0.25f);
        let river_bed_shaded_clean = occlusion_from_height(river_bed_ground_near_height.x, 0.15f);
        let river_bed_shaded_open = occlusion_from_height(river_bed_ground_near_height.x, 0.7f);
        let river_bed_shaded_soiled = mul_vec3(river_bed_varied_varied, vec3f(river_bed_shaded_clean));
        let river_bed_watered_level = mul_f32(parameters.river_bed_wetness, 1.3f);
        let river_bed_watered_shore = sub_f32(river_bed_watered_level, 0.35f);
        let river_bed_watered_soaked = ramp_smooth(river_bed_ground_near_height.x, river_bed_watered_level, river_bed_watered_shore);
        let river_bed_watered_strength = mul_f32(river_bed_watered_soaked, parameters.river_bed_wetness);
        let river_bed_watered_water = wet(river_bed_shaded_soiled, 0.85f, river_bed_watered_strength);
        albedo += river_bed_weight * river_bed_watered_water.albedo;
        slopes += river_bed_weight * layer_slopes(river_bed_ground_bent);
        roughness += river_bed_weight * river_bed_watered_water.roughness;
        occlusion += river_bed_weight * river_bed_shaded_open;
        weight += river_bed_weight;
    }

    // granite: graphs/surfaces/granite.ron
    if granite_weight > TERRANE_VISIBLE {
        let granite_stone_far_tile = mul_f32(parameters.granite_tile, 7.3f);
        let granite_stone_far_height = triplanar(fine_data_1024x1024, repeat_linear_4_sampler, 4i, terrain.position, terrain.normal, granite_stone_far_tile, 4.0f);
        let granite_stone_far_normal = triplanar_normal(data_1024x1024, repeat_linear_4_sampler, 4i, terrain.position, terrain.normal, granite_stone_far_tile, 4.0f, 1.2f);
        let granite_stone_near_color = triplanar(color_1024x1024, repeat_linear_4_sampler, 4i, terrain.position, terrain.normal, parameters.granite_tile, 4.0f);
        let granite_stone_mottled = macro_blend(granite_stone_near_color.xyz, granite_stone_far_height.x, 0.8f);
        let granite_stone_near_normal = triplanar_normal(data_1024x1024, repeat_linear_4_sampler, 4i, terrain.position, terrain.normal, parameters.granite_tile, 4.0f, 1.2f);
        let granite_stone_bent = normal_whiteout(granite_stone_far_normal, granite_stone_near_normal);
        let granite_polish = roughness_from_height(granite_stone_near_height.x, 1.0f, 1.0f, 0.72f, 0.92f);
        let granite_tinted = mul_vec3(granite_stone_mottled, parameters.granite_tint);
        let granite_varied_amount = mul_f32(dry_grass_varied_patch, 0.4f);
        let granite_varied_hued = tint(granite_tinted, vec3f(0.38f, 0.35f, 0.32f), granite_varied_amount);
        let granite_varied_varied = macro_blend(granite_varied_hued, dry_grass_varied_wide, 0.25f);
        let granite_shaded_clean = occlusion_from_height(granite_stone_near_height.x, 0.25f);
        let granite_shaded_open = occlusion_from_height(granite_stone_near_height.x, 0.7f);
        let granite_shaded_soiled = mul_vec3(granite_varied_varied, vec3f(granite_shaded_clean));
        albedo += granite_weight * granite_shaded_soiled;
        slopes += granite_weight * layer_slopes(granite_stone_bent);
        roughness += granite_weight * granite_polish;
        occlusion += granite_weight * granite_shaded_open;
        weight += granite_weight;
    }

    // scree: graphs/surfaces/scree.ron
    if scree_weight > TERRANE_VISIBLE {
        let scree_ground_far_tile = mul_f32(parameters.scree_tile, 6.7f);
        let scree_ground_far_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 3i, terrain.position, scree_ground_far_tile, 0.7f, 1.0f, 17u);
        let scree_ground_far_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 3i, terrain.position, scree_ground_far_tile, 0.7f, 1.0f, 17u, 0.54f);
        let scree_ground_near_color = hex_tile(color_1024x1024, repeat_linear_4_sampler, 3i, terrain.position, parameters.scree_tile, 0.7f, 1.0f, 0u);
        let scree_ground_mottled = macro_blend(scree_ground_near_color.xyz, scree_ground_far_height.x, 0.35f);
        let scree_ground_near_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 3i, terrain.position, parameters.scree_tile, 0.7f, 1.0f, 0u, 1.2f);
        let scree_ground_bent = normal_whiteout(scree_ground_far_normal, scree_ground_near_normal);
        let scree_tinted = mul_vec3(scree_ground_mottled, parameters.scree_tint);
        let scree_varied_hued = tint(scree_tinted, parameters.scree_hue, lush_grass_varied_amount);
        let scree_varied_varied = macro_blend(scree_varied_hued, dry_grass_varied_wide, 0.3f);
        let scree_shaded_clean = occlusion_from_height(scree_ground_near_height.x, 0.2f);
        let scree_shaded_open = occlusion_from_height(scree_ground_near_height.x, 0.75f);
        let scree_shaded_soiled = mul_vec3(scree_varied_varied, vec3f(scree_shaded_clean));
        albedo += scree_weight * scree_shaded_soiled;
        slopes += scree_weight * layer_slopes(scree_ground_bent);
        roughness += scree_weight * 0.92f;
        occlusion += scree_weight * scree_shaded_open;
        weight += scree_weight;
    }

    // conifer_wood: graphs/surfaces/conifer_wood.ron
    if conifer_wood_weight > TERRANE_VISIBLE {
        let conifer_wood_kind = levels(conifer_wood_trees.id, 0.55f, 1.0f, 1.0f);
        let conifer_wood_needles = lerp_vec3(parameters.conifer_wood_spruce, parameters.conifer_wood_larch, conifer_wood_kind);
        let conifer_wood_roof = normal_from_slope(conifer_wood_trees.slope, parameters.conifer_wood_tall);
        let conifer_wood_varied_amount = mul_f32(dry_grass_varied_patch, 0.25f);
        let conifer_wood_varied_hued = tint(conifer_wood_needles, vec3f(0.3f, 0.3f, 0.1f), conifer_wood_varied_amount);
        let conifer_wood_varied_varied = macro_blend(conifer_wood_varied_hued, dry_grass_varied_wide, 0.3f);
        let conifer_wood_shaded_clean = occlusion_from_height(conifer_wood_trees.height, 0.55f);
        let conifer_wood_shaded_open = occlusion_from_height(conifer_wood_trees.height, 0.8f);
        let conifer_wood_shaded_soiled = mul_vec3(conifer_wood_varied_varied, vec3f(conifer_wood_shaded_clean));
        albedo += conifer_wood_weight * conifer_wood_shaded_soiled;
        slopes += conifer_wood_weight * layer_slopes(conifer_wood_roof);
        roughness += conifer_wood_weight * 1.0f;
        occlusion += conifer_wood_weight * conifer_wood_shaded_open;
        weight += conifer_wood_weight;
    }

    // forest_floor: graphs/surfaces/forest_floor.ron
    if forest_floor_weight > TERRANE_VISIBLE {
        let forest_floor_ground_far_tile = mul_f32(parameters.forest_floor_tile, 6.7f);
        let forest_floor_ground_far_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 2i, terrain.position, forest_floor_ground_far_tile, 0.7f, 1.0f, 17u);
        let forest_floor_ground_far_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 2i, terrain.position, forest_floor_ground_far_tile, 0.7f, 1.0f, 17u, 0.45f);
        let forest_floor_ground_near_color = hex_tile(color_1024x1024, repeat_linear_4_sampler, 2i, terrain.position, parameters.forest_floor_tile, 0.7f, 1.0f, 0u);
        let forest_floor_ground_mottled = macro_blend(forest_floor_ground_near_color.xyz, forest_floor_ground_far_height.x, 0.45f);
        let forest_floor_ground_near_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 2i, terrain.position, parameters.forest_floor_tile, 0.7f, 1.0f, 0u, 1.0f);
        let forest_floor_ground_bent = normal_whiteout(forest_floor_ground_far_normal, forest_floor_ground_near_normal);
        let forest_floor_tinted = mul_vec3(forest_floor_ground_mottled, parameters.forest_floor_tint);
        let forest_floor_varied_amount = mul_f32(dry_grass_varied_patch, 0.6f);
        let forest_floor_varied_hued = tint(forest_floor_tinted, parameters.forest_floor_moss, forest_floor_varied_amount);
        let forest_floor_varied_varied = macro_blend(forest_floor_varied_hued, dry_grass_varied_wide, 0.35f);
        let forest_floor_shaded_clean = occlusion_from_height(forest_floor_ground_near_height.x, 0.25f);
        let forest_floor_shaded_open = occlusion_from_height(forest_floor_ground_near_height.x, 0.7f);
        let forest_floor_shaded_soiled = mul_vec3(forest_floor_varied_varied, vec3f(forest_floor_shaded_clean));
        albedo += forest_floor_weight * forest_floor_shaded_soiled;
        slopes += forest_floor_weight * layer_slopes(forest_floor_ground_bent);
        roughness += forest_floor_weight * 0.9f;
        occlusion += forest_floor_weight * forest_floor_shaded_open;
        weight += forest_floor_weight;
    }

    // lush_grass: graphs/surfaces/lush_grass.ron
    if lush_grass_weight > TERRANE_VISIBLE {
        let lush_grass_ground_far_tile = mul_f32(parameters.lush_grass_tile, 6.7f);
        let lush_grass_ground_far_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 1i, terrain.position, lush_grass_ground_far_tile, 0.7f, 1.0f, 17u);
        let lush_grass_ground_far_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 1i, terrain.position, lush_grass_ground_far_tile, 0.7f, 1.0f, 17u, 0.45f);
        let lush_grass_ground_near_color = hex_tile(color_1024x1024, repeat_linear_4_sampler, 1i, terrain.position, parameters.lush_grass_tile, 0.7f, 1.0f, 0u);
        let lush_grass_ground_mottled = macro_blend(lush_grass_ground_near_color.xyz, lush_grass_ground_far_height.x, 0.4f);
        let lush_grass_ground_near_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 1i, terrain.position, parameters.lush_grass_tile, 0.7f, 1.0f, 0u, 1.0f);
        let lush_grass_ground_bent = normal_whiteout(lush_grass_ground_far_normal, lush_grass_ground_near_normal);
        let lush_grass_tinted = mul_vec3(lush_grass_ground_mottled, parameters.lush_grass_tint);
        let lush_grass_varied_hued = tint(lush_grass_tinted, parameters.lush_grass_hue, lush_grass_varied_amount);
        let lush_grass_varied_varied = macro_blend(lush_grass_varied_hued, dry_grass_varied_wide, 0.35f);
        let lush_grass_shaded_clean = occlusion_from_height(lush_grass_ground_near_height.x, 0.25f);
        let lush_grass_shaded_open = occlusion_from_height(lush_grass_ground_near_height.x, 0.7f);
        let lush_grass_shaded_soiled = mul_vec3(lush_grass_varied_varied, vec3f(lush_grass_shaded_clean));
        albedo += lush_grass_weight * lush_grass_shaded_soiled;
        slopes += lush_grass_weight * layer_slopes(lush_grass_ground_bent);
        roughness += lush_grass_weight * 0.85f;
        occlusion += lush_grass_weight * lush_grass_shaded_open;
        weight += lush_grass_weight;
    }

    // dry_grass: graphs/surfaces/dry_grass.ron
    if dry_grass_weight > TERRANE_VISIBLE {
        let dry_grass_ground_far_tile = mul_f32(parameters.dry_grass_tile, 6.7f);
        let dry_grass_ground_far_height = hex_tile(fine_data_1024x1024, repeat_linear_4_sampler, 0i, terrain.position, dry_grass_ground_far_tile, 0.7f, 1.0f, 17u);
        let dry_grass_ground_far_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 0i, terrain.position, dry_grass_ground_far_tile, 0.7f, 1.0f, 17u, 0.45f);
        let dry_grass_ground_near_color = hex_tile(color_1024x1024, repeat_linear_4_sampler, 0i, terrain.position, parameters.dry_grass_tile, 0.7f, 1.0f, 0u);
        let dry_grass_ground_mottled = macro_blend(dry_grass_ground_near_color.xyz, dry_grass_ground_far_height.x, 0.4f);
        let dry_grass_ground_near_normal = hex_tile_normal(data_1024x1024, repeat_linear_4_sampler, 0i, terrain.position, parameters.dry_grass_tile, 0.7f, 1.0f, 0u, 1.0f);
        let dry_grass_ground_bent = normal_whiteout(dry_grass_ground_far_normal, dry_grass_ground_near_normal);
        let dry_grass_tinted = mul_vec3(dry_grass_ground_mottled, parameters.dry_grass_tint);
        let dry_grass_varied_amount = mul_f32(dry_grass_varied_patch, 0.5f);
        let dry_grass_varied_hued = tint(dry_grass_tinted, parameters.dry_grass_hue, dry_grass_varied_amount);
        let dry_grass_varied_varied = macro_blend(dry_grass_varied_hued, dry_grass_varied_wide, 0.35f);
        let dry_grass_shaded_clean = occlusion_from_height(dry_grass_ground_near_height.x, 0.25f);
        let dry_grass_shaded_open = occlusion_from_height(dry_grass_ground_near_height.x, 0.7f);
        let dry_grass_shaded_soiled = mul_vec3(dry_grass_varied_varied, vec3f(dry_grass_shaded_clean));
        albedo += dry_grass_weight * dry_grass_shaded_soiled;
        slopes += dry_grass_weight * layer_slopes(dry_grass_ground_bent);
        roughness += dry_grass_weight * 0.88f;
        occlusion += dry_grass_weight * dry_grass_shaded_open;
        weight += dry_grass_weight;
    }

    return TerrainOut(albedo / weight, layer_normal(slopes / weight), roughness / weight, 0.0f, occlusion / weight, vec3f(0.0f, 0.0f, 0.0f));
}
