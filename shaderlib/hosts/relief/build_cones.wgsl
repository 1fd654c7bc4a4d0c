//! The steepest way up from every cell, made on the device as `heightfield/cones/square.rs` makes it: by the highest of squares
//! that grow ring by ring. It is the same to the last bit. Climbs are whole numbers that f32 holds, a slope is one product of
//! such a number and a share that the host has divided, WGSL rounds a product correctly, and with no sum behind it there is
//! nothing that a compiler could fuse it with; which slope is the largest does not depend on the order.

/// Squares of the level, a layer for each power of two; the last layer has the heights of the texels.
@group(1) @binding(0) var build_table: texture_2d_array<u32>;
/// The slopes to what lies nearer, toward the four quadrants: bit 0 of their number is set toward smaller x, bit 1 toward smaller y.
@group(1) @binding(1) var build_slopes: texture_2d<f32>;
@group(1) @binding(2) var<uniform> build_rings: BuildRings;

/// The layer of heights.
const build_ground: i32 = 6;

/// Whether one slope stands for all quadrants.
override build_is_round_about: bool = false;

/// What is new in squares that have grown: `Ring` of `heightfield/cones/rings.rs`.
struct BuildRing {
    /// Nodes beyond the first.
    reach: i32,
    /// The layer of the largest squares that are no larger.
    layer: i32,
    /// One over the least distance, in texels, and over twice that of the diagonal's middle or 0.
    share: f32,
    middle: f32,
}

/// Those of one level.
struct BuildRings {
    rings: array<BuildRing, 32>,
    count: i32,
    level: u32,
}

/// The slopes from a cell to what is nearer than this level, steepened by what lies in its rings.
@fragment
fn build_steepened(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let at = vec2i(position.xy);
    let tip = build_texel(at);
    let node = (at >> vec2u(build_rings.level)) + build_around;
    // The last ring's squares hold those of all others.
    let most = vec4f(build_highest(node, build_rings.rings[max(build_rings.count, 1i) - 1i]) - vec4u(tip));
    var slopes = build_slopes_at(at);
    var index = 0i;
    // Shares fall from ring to ring: where not even the highest of all would be steeper, nothing farther is.
    while index < build_rings.count && any(build_share(index) * most > slopes) {
        let ring = build_rings.rings[index];
        slopes = max(slopes, vec4f(build_highest(node, ring) - vec4u(tip)) * ring.share);
        if ring.middle > 0.0 {
            slopes = max(slopes, vec4f(build_middles(node, ring.reach, tip)) * ring.middle);
        }
        slopes = select(slopes, vec4f(build_largest(slopes)), build_is_round_about);
        index += 1i;
    }
    return slopes;
}

/// The slopes that are stored of a cell.
fn build_slopes_at(at: vec2i) -> vec4f {
    let stored = textureLoad(build_slopes, at, 0i);
    return select(stored, stored.rrrr, build_is_round_about);
}

fn build_largest(slopes: vec4f) -> f32 {
    return max(max(slopes.x, slopes.y), max(slopes.z, slopes.w));
}

/// One over the distance of what is nearest in a ring: two climbs count for the middle of a diagonal.
fn build_share(index: i32) -> f32 {
    return max(build_rings.rings[index].share, 2.0 * build_rings.rings[index].middle);
}

/// What stands highest in the squares toward each quadrant, the node itself in their corner.
fn build_highest(node: vec2i, ring: BuildRing) -> vec4u {
    let before = node - ring.reach;
    return vec4u(
        build_square(node, ring),
        build_square(vec2i(before.x, node.y), ring),
        build_square(vec2i(node.x, before.y), ring),
        build_square(before, ring),
    );
}

/// What stands highest in a square: in four that overlap and make it up.
fn build_square(first: vec2i, ring: BuildRing) -> u32 {
    let second = first + (ring.reach + 1i - (1i << u32(ring.layer)));
    let above = max(build_entry(first, ring.layer), build_entry(vec2i(second.x, first.y), ring.layer));
    let below = max(build_entry(vec2i(first.x, second.y), ring.layer), build_entry(second, ring.layer));
    return max(above, below);
}

fn build_entry(at: vec2i, layer: i32) -> u32 {
    return textureLoad(build_table, at, layer, 0i).r;
}

/// The climbs, together, to both corners beside the diagonal of the cell that is so far away, toward each quadrant.
fn build_middles(cell: vec2i, reach: i32, tip: u32) -> vec4u {
    let left = vec2i(1i - reach, -reach) + cell.x;
    let right = vec2i(reach, reach + 1i) + cell.x;
    let up = vec2i(1i - reach, -reach) + cell.y;
    let down = vec2i(reach, reach + 1i) + cell.y;
    return vec4u(
        build_beside(right, down, tip),
        build_beside(left, down, tip),
        build_beside(right, up, tip),
        build_beside(left, up, tip),
    );
}

/// The climbs to two corners of a cell, of each axis its nearer and its farther side.
fn build_beside(x: vec2i, y: vec2i, tip: u32) -> u32 {
    let beside = max(build_entry(vec2i(x.y, y.x), build_ground), tip) - tip;
    let below = max(build_entry(vec2i(x.x, y.y), build_ground), tip) - tip;
    return beside + below;
}
