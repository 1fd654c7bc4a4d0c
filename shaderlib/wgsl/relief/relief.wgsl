//! What all relief methods share: the ray, what it meets, and the exact patch under it; not a node.
//!
//! Positions count in texels from the centre of the first texel, heights in steps of the map. Texel (i, j) has its centre at
//! (i, j), cell (i, j) lies between it and (i + 1, j + 1), and over the cell the surface is the bilinear patch through its
//! four texels. Every method traces this one surface.
//! Source: Terrane; the patch after Ramsey, Potter and Hansen, "Ray Bilinear Patch Intersections", JGT 2004, for height fields one quadratic.

/// How one mip of a height map is read, and the bounds over its cells.
struct ReliefField {
    /// Sides less 1 of the map's cells where it wraps, both powers of two; -1 where it does not.
    wrap: vec2i,
    /// The last column and row of texels.
    last: vec2i,
    /// What is added to a cell before it is shifted to a node: that is the node's texel in the image of bounds.
    corner: vec2i,
    /// The coarsest level of the bounds.
    top: i32,
    /// Nodes that may be visited before the search is given up as unresolved.
    limit: u32,
    /// The mip of the heights.
    mip: i32,
    /// The layer of the textures.
    layer: i32,
    /// Where the mip's first patch stands in an image of patches or of cells.
    patches: vec2i,
    /// log2 of the steps of height to a step of a wide node's base.
    unit: i32,
    /// Where the mip's first coarse node stands in an image of cells; -1 where a search does not begin there.
    coarse: vec2i,
}

/// A ray that comes down on the map, or leaves the ground.
struct ReliefRay {
    /// The cell that it starts in.
    cell: vec2i,
    /// Where in that cell, 0..1; z in steps.
    origin: vec3f,
    /// How far 1 of t leads. The larger of |x| and |y| is 1, unless the ray is vertical.
    direction: vec3f,
    /// The ray is looked at for t in 0..end.
    end: f32,
}

/// What a search found.
struct ReliefHit {
    /// Where on the ray; `end` where nothing was met.
    t: f32,
    /// RELIEF_MISS, RELIEF_HIT or RELIEF_UNRESOLVED.
    state: u32,
    /// The cell that was met.
    cell: vec2i,
    /// Nodes visited, or samples taken.
    steps: u32,
    /// Patches loaded and intersected.
    leaves: u32,
}

const RELIEF_MISS: u32 = 0u;
const RELIEF_HIT: u32 = 1u;
/// The limit was reached: neither hit nor miss, and never shown as either.
const RELIEF_UNRESOLVED: u32 = 2u;

/// More than any t.
const RELIEF_NEVER: f32 = 1e30;

/// A node is passed over only if the ray stays so many steps above its bound: more than rounding moves a ray 2^17 steps high.
const RELIEF_PAD: f32 = 0.125;

/// Smallest component of a direction, 2^-60: no path is long enough to show it, and its inverse is far from overflow.
const RELIEF_LEAST: f32 = 8.673617379884035e-19;

/// log2 of the cells along a coarse node.
const RELIEF_COARSE: u32 = 3u;

/// The height of a texel in steps.
fn relief_texel(heights: texture_2d_array<u32>, field: ReliefField, texel: vec2i) -> f32 {
    return f32(textureLoad(heights, min(texel & field.wrap, field.last), field.layer, field.mip).r);
}

/// The largest height over a node, in steps.
fn relief_bound(bounds: texture_2d_array<u32>, field: ReliefField, cell: vec2i, level: i32) -> f32 {
    return f32(textureLoad(bounds, ((cell & field.wrap) + field.corner) >> vec2u(u32(level)), field.layer, 0i).r);
}

/// The four heights of a cell in a mirrored frame: at its corner, one along x, one along y, and both.
fn relief_corners(heights: texture_2d_array<u32>, field: ReliefField, cell: vec2i, mirror: vec2i) -> vec4f {
    // Cell c is the mirror image of cell -1 - c, and texel c that of texel -c.
    let near = (cell ^ mirror) - mirror;
    let far = ((cell + 1i) ^ mirror) - mirror;
    return vec4f(
        relief_texel(heights, field, near),
        relief_texel(heights, field, vec2i(far.x, near.y)),
        relief_texel(heights, field, vec2i(near.x, far.y)),
        relief_texel(heights, field, far),
    );
}

/// The height of a patch at a place in its cell.
fn relief_height(corners: vec4f, place: vec2f) -> f32 {
    return mix(mix(corners.x, corners.y, place.x), mix(corners.z, corners.w, place.x), place.y);
}

/// The heights of a cell as a mirrored frame has them.
fn relief_mirrored(corners: vec4f, mirror: vec2i) -> vec4f {
    let along = select(corners, corners.yxwz, mirror.x != 0i);
    return select(along, along.zwxy, mirror.y != 0i);
}

/// How far on a ray meets a patch: the first root in 0..span, or RELIEF_NEVER. `place` is in the cell, z in steps.
///
/// The ray's height less the patch's is a quadratic in t; of the two forms of each root that one is taken which does not
/// subtract nearly equal numbers. The patch ends with its cell: continued by no more than what rounding moves a ray, the side of
/// a wall would stand over its edge.
fn relief_patch(corners: vec4f, place: vec3f, direction: vec3f, span: f32) -> f32 {
    let along = corners.yz - corners.x;
    let twist = corners.w - corners.y - along.y;
    let start = saturate(place.xy);
    let a0 = place.z - (corners.x + along.x * start.x + (along.y + twist * start.x) * start.y);
    let a1 = direction.z
        - (dot(along, direction.xy) + twist * (start.x * direction.y + start.y * direction.x));
    let a2 = -twist * direction.x * direction.y;
    let square = a1 * a1 - 4.0 * a2 * a0;
    let root = sqrt(max(square, 0.0));
    let down = a1 < 0.0;
    let over = select(a1 + root, 2.0 * a0, down);
    let under = select(-2.0 * a2, root - a1, down);
    let t = over / max(under, 1e-20);
    let inside = all(abs(start + direction.xy * t - 0.5) <= vec2f(0.5));
    let met = square >= 0.0 && under > 0.0 && t <= span && inside;
    return select(select(RELIEF_NEVER, t, met), 0.0, a0 <= 0.0);
}

/// The normal of a cell's patch at a place in it, z up, of length 1; `steps` of height are as long as a texel is wide.
fn relief_normal(corners: vec4f, place: vec2f, steps: f32) -> vec3f {
    let along = corners.yz - corners.x;
    let twist = corners.w - corners.y - along.y;
    return normalize(vec3f(-(along + twist * place.yx), steps));
}
