//! Displaced layers: the relief of the materials that meet at a place, in the place's own frame. Not a node.
//!
//! The frame has x and y in the ground and z out of it, in metres from where the eye's ray meets the ground. Height 1 of a layer
//! lies `sink` under the ground, height 0 `depth` under that, and the ground is the highest of its layers. A layer is sunk by
//! what its share lacks of the largest one: whoever covers most stands at the level of the ground, and a layer whose share goes
//! to 0 sinks out of sight, so that the surface is continuous wherever the shares are.
//! Source: Terrane; displacement down from the ground after Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro 1, 2010, sections 1.4 and 1.7.3 (the highest surface wins).

/// The relief of one layer.
struct DisplacedLayer {
    /// The cell of the finest mip under the place.
    cell: vec2i,
    /// Where in it, 0..1.
    place: vec2f,
    /// Texels per metre along x.
    along_x: vec2f,
    /// Texels per metre along y.
    along_y: vec2f,
    /// Metres from height 1 down to height 0; 0 for a layer that is not there.
    depth: f32,
    /// Metres from the ground down to height 1.
    sink: f32,
    /// log2 of the texels that a pixel is wide, at least 0.
    level: f32,
    /// Texels of its map.
    size: vec2i,
    /// The layer of its textures.
    layer: i32,
}

/// A ray in the frame of a place; its direction has length 1.
struct DisplacedRay {
    /// Where it starts.
    origin: vec3f,
    /// Where it leads.
    direction: vec3f,
}

/// Where a ray meets the displaced ground.
struct DisplacedHit {
    /// Metres along the ray.
    distance: f32,
    /// Nodes and samples that were read on the way.
    steps: u32,
    /// Whether the search came to its end.
    done: bool,
}

/// A cell of a mip, and a place in it.
struct DisplacedCell {
    /// The cell.
    cell: vec2i,
    /// Where in it, 0..1.
    place: vec2f,
}

/// A ray as a method takes it, and the way back to metres.
struct DisplacedSearch {
    /// What is traced.
    ray: ReliefRay,
    /// Metres along the ray where t is 0.
    start: f32,
    /// Metres for 1 of t.
    unit: f32,
}

/// Steps of height between 0 and 1.
const DISPLACED_STEPS: f32 = 65535.0;

/// Nodes after which a search is given up; no path through a map of 4096 x 4096 texels has as many.
const DISPLACED_LIMIT: u32 = 16384u;

/// log2 of the steps of height to a step of a wide node's base, of maps of 16 bits.
const DISPLACED_WIDE_UNIT: i32 = 4i;

/// Texels along the shorter side of a mip from which on searches from cone to cone begin over coarse nodes.
const DISPLACED_LARGE: i32 = 4096i;

/// Longest path in texels of a mip: whole numbers up to it leave f32 room for a fraction.
const DISPLACED_LONGEST: f32 = 65536.0;

/// A layer where the coordinates of its map are `coordinates`, whose gradients are per metre along x and y. `pixel` is the width
/// of a pixel in metres, `size` that of the map in texels, whose sides are powers of two.
fn displaced_layer(
    coordinates: Coord,
    size: vec2i,
    layer: i32,
    depth: f32,
    sink: f32,
    pixel: f32,
) -> DisplacedLayer {
    let texels = vec2f(size);
    let at = coordinates.uv * texels - 0.5;
    let cell = floor(at);
    let along_x = coordinates.ddx * texels;
    let along_y = coordinates.ddy * texels;
    let area = abs(along_x.x * along_y.y - along_x.y * along_y.x);
    let level = 0.5 * log2(max(area, 1e-12)) + log2(max(pixel, 1e-12));
    return DisplacedLayer(
        vec2i(cell),
        at - cell,
        along_x,
        along_y,
        depth,
        sink,
        clamp(level, 0.0, f32(firstLeadingBit(min(size.x, size.y)))),
        size,
        layer,
    );
}

/// log2 of the texels in a metre of a layer; far below 0 for one that is not there.
fn displaced_texels(layer: DisplacedLayer) -> f32 {
    let area = abs(layer.along_x.x * layer.along_y.y - layer.along_x.y * layer.along_y.x);
    return select(-64.0, 0.5 * log2(max(area, 1e-12)), layer.depth > 0.0);
}

/// Share of the depth that is left between the distances where relief begins to fade and where it is gone.
fn displaced_fade(distance: f32, near: f32, far: f32) -> f32 {
    return 1.0 - smoothstep(near, far, distance);
}

/// How far a layer is sunk.
fn displaced_sink(share: f32, largest: f32, deepest: f32) -> f32 {
    return deepest * saturate(1.0 - share / max(largest, 1e-6));
}

/// How a mip of a layer's map is read.
fn displaced_field(layer: DisplacedLayer, mip: i32) -> ReliefField {
    let sides = layer.size >> vec2u(u32(mip));
    // Coarser mips lie beneath the finest one, each to the right of the one before.
    let patches = vec2i(layer.size.x - 2i * sides.x, layer.size.y);
    return ReliefField(
        sides - 1i,
        sides - 1i,
        vec2i(mip * sides.x, sides.y),
        firstLeadingBit(min(sides.x, sides.y)),
        DISPLACED_LIMIT,
        mip,
        layer.layer,
        select(patches, vec2i(0), mip == 0i),
        DISPLACED_WIDE_UNIT,
        select(displaced_coarse(layer, sides), vec2i(-1), any(sides < vec2i(DISPLACED_LARGE))),
    );
}

/// Where the coarse nodes of a mip of so many cells stand in an image of cells: under the mip of that size.
fn displaced_coarse(layer: DisplacedLayer, sides: vec2i) -> vec2i {
    let nodes = sides >> vec2u(RELIEF_COARSE);
    return vec2i(layer.size.x - 2i * nodes.x, layer.size.y + nodes.y);
}

/// The same where bounds are those of `wide` and begin at `first`.
fn displaced_field_wide(layer: DisplacedLayer, mip: i32, first: i32) -> ReliefField {
    var field = displaced_field(layer, mip);
    // A map of fewer cells than a node has children is repeated.
    let sides = max(layer.size >> vec2u(u32(mip)), vec2i(4));
    field.corner = vec2i(first, firstLeadingBit(sides.x));
    field.top = firstLeadingBit(min(sides.x, sides.y)) / 2i;
    return field;
}

/// The cell of a mip at a point of the frame.
fn displaced_cell(layer: DisplacedLayer, at: vec2f, mip: i32) -> DisplacedCell {
    let shift = vec2u(u32(mip));
    // Whole cells apart from fractions: a texel of a mip stands in the middle of those that it covers.
    let cells = layer.place + at.x * layer.along_x + at.y * layer.along_y;
    let whole = layer.cell + vec2i(floor(cells));
    let base = whole >> shift;
    let inner = vec2f(whole - (base << shift)) + (cells - floor(cells));
    let place = (inner + 0.5) / f32(1i << u32(mip)) - 0.5;
    return DisplacedCell(base + vec2i(floor(place)), place - floor(place));
}

/// The ray over a mip of a layer's map, from where it is no higher than height 1, or from its origin, to height 0.
fn displaced_search(layer: DisplacedLayer, ray: DisplacedRay, mip: i32) -> DisplacedSearch {
    let steps = DISPLACED_STEPS / layer.depth;
    let fall = max(-ray.direction.z, 1e-4);
    let start = max(ray.origin.z + layer.sink, 0.0) / fall;
    let at = ray.origin + ray.direction * start;
    let side = f32(1i << u32(mip));
    let texels = (ray.direction.x * layer.along_x + ray.direction.y * layer.along_y) / side;
    let rate = vec3f(texels, -fall * steps);
    // A ray straight down is counted by its height, so that nothing overflows.
    let unit = 1.0 / max(max(abs(rate.x), abs(rate.y)), -rate.z / 131072.0);
    let first = displaced_cell(layer, at.xy, mip);
    let height = min(DISPLACED_STEPS, DISPLACED_STEPS + (at.z + layer.sink) * steps);
    let end = min((height + 1.0) / (-rate.z * unit), DISPLACED_LONGEST);
    let sent = ReliefRay(first.cell, vec3f(first.place, height), rate * unit, max(end, 0.0));
    return DisplacedSearch(sent, start, unit);
}

/// The hit of a method in metres. A ray that ends before it meets anything ends on height 0.
fn displaced_found(search: DisplacedSearch, hit: ReliefHit) -> DisplacedHit {
    return DisplacedHit(search.start + search.unit * hit.t, hit.steps + hit.leaves, hit.state != RELIEF_UNRESOLVED);
}

/// A single look at the height of a mip under the origin.
fn displaced_glance_on(heights: texture_2d_array<u32>, field: ReliefField, search: DisplacedSearch) -> DisplacedHit {
    let corners = relief_corners(heights, field, search.ray.cell, vec2i(0));
    let part = search.ray.origin.xy;
    let height = relief_height(corners, part);
    let t = clamp((height - search.ray.origin.z) / min(search.ray.direction.z, -1e-6), 0.0, search.ray.end);
    return DisplacedHit(search.start + search.unit * t, 1u, true);
}

/// Texels of the way over the map.
fn displaced_way(search: DisplacedSearch) -> f32 {
    return search.ray.end * max(abs(search.ray.direction.x), abs(search.ray.direction.y));
}

/// How much of the next mip shows: nothing in the first half between two levels, so that half of all pixels need one search.
fn displaced_coarser(level: f32) -> f32 {
    return saturate(2.0 * fract(level) - 1.0);
}

/// Mips that show: one, or two.
fn displaced_mips(layer: DisplacedLayer) -> i32 {
    return select(1i, 2i, displaced_coarser(layer.level) > 0.0);
}

/// The part that each of them has, the finer one first.
fn displaced_part(layer: DisplacedLayer, coarser: i32) -> f32 {
    let part = displaced_coarser(layer.level);
    return select(part, 1.0 - part, coarser == 0i);
}

/// What was found on a mip, with its part, on top of what was found on those before it.
fn displaced_between(before: DisplacedHit, found: DisplacedHit, part: f32) -> DisplacedHit {
    let distance = before.distance + part * found.distance;
    return DisplacedHit(distance, before.steps + found.steps, before.done && found.done);
}

/// A single look at the height under the origin, on the mip that fits the pixel or between two: good enough where the whole way is
/// short.
fn displaced_glance(heights: texture_2d_array<u32>, layer: DisplacedLayer, ray: DisplacedRay) -> DisplacedHit {
    var hit = DisplacedHit(0.0, 0u, true);
    for (var coarser = 0i; coarser < displaced_mips(layer); coarser++) {
        let mip = i32(layer.level) + coarser;
        let field = displaced_field(layer, mip);
        let found = displaced_glance_on(heights, field, displaced_search(layer, ray, mip));
        hit = displaced_between(hit, found, displaced_part(layer, coarser));
    }
    return hit;
}

/// The nearer of two hits.
fn displaced_nearer(a: DisplacedHit, b: DisplacedHit) -> DisplacedHit {
    return DisplacedHit(min(a.distance, b.distance), a.steps + b.steps, a.done && b.done);
}

/// Where a falling ray meets a plane so many metres under the ground.
fn displaced_plane(ray: DisplacedRay, under: f32) -> DisplacedHit {
    return DisplacedHit(max(ray.origin.z + under, 0.0) / max(-ray.direction.z, 1e-4), 0u, true);
}
