//! Quadtree displacement mapping as published, with its optimisations as switches: the ray moves to the plane of a node's
//! highest texel, or to the border of the node where that is nearer, and the search goes down until it is below single texels.
//! No guarantee: the bounds are those of texels, not of the surface between them, and so are the borders.
//!
//! The listing counts depth downwards from where the ray starts. Here t takes its place: both grow alike along a ray that comes
//! down. Coordinates count texels of the tile from its corner, which rounds as the listing's do.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro 1, 2010, listing 1.3 and section 1.4.3.

/// What section 1.4.3 adds to the listing, and what the listing leaves open.
struct QuadtreeDisplacementSwitches {
    /// The listing's division of whole numbers by whole numbers, which leaves of all borders those of the tile.
    integers: bool,
    /// What 0 / 0 counts for among distances: RELIEF_NEVER if a minimum passes over it, as Direct3D's does.
    undefined: f32,
    /// At a border up by a level; else on the same one.
    ascends: bool,
    /// Nodes after which the place reached counts as a hit, for a ray straight down and for a level one; 0 for never.
    caps: vec2f,
    /// A texel is as wide as so many steps are high.
    steep: f32,
    /// Ends with a step of linear search, from a texel before to a texel behind.
    refines: bool,
    /// The level below which the search does not go.
    stop: f32,
    /// There, a mix with the level above by the fraction of `stop`.
    interpolates: bool,
    /// How much of the shift is left: 1 near the eye, 0 where relief has faded into normal mapping.
    keep: f32,
}

/// The place that the listing stops at, a hit unless the ray ends before; `bounds` over texels. A ray that does not come down
/// is unresolved: the listing moves it by its depth.
fn quadtree_displacement_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    switches: QuadtreeDisplacementSwitches,
) -> ReliefHit {
    let last = min(i32(switches.stop), field.top);
    let cap = quadtree_displacement_cap(field, ray, switches);
    var level = field.top;
    var t = 0.0;
    var loads = 0u;
    for (var step = 0u; level >= last && step < cap; step++) {
        if step >= field.limit || ray.direction.z >= 0.0 {
            return ReliefHit(t, RELIEF_UNRESOLVED, vec2i(0), loads, 0u);
        }
        let mixes = switches.interpolates && level == last;
        loads += select(1u, 2u, mixes);
        let next = select(0.0, fract(switches.stop), mixes);
        let height = quadtree_displacement_height(bounds, field, ray, t, level, next);
        let d = (height - ray.origin.z) / ray.direction.z;
        if d > t {
            let border = quadtree_displacement_border(field, ray, t, d, level, switches);
            level += select(0i, select(1i, 2i, switches.ascends), border < QUADTREE_DISPLACEMENT_INSIDE);
            t = min(d, border);
        }
        if t > ray.end {
            return ReliefHit(ray.end, RELIEF_MISS, vec2i(0), loads, 0u);
        }
        level--;
    }
    if switches.refines {
        t = quadtree_displacement_refined(heights, field, ray, t);
        loads += 2u;
    }
    t *= switches.keep;
    return ReliefHit(t, RELIEF_HIT, ray.cell + vec2i(floor(ray.origin.xy + ray.direction.xy * t)), loads, 0u);
}

/// Where a ray is in the tile, in texels from its corner: half a texel from the centre of the first.
fn quadtree_displacement_place(field: ReliefField, ray: ReliefRay, t: f32) -> vec2f {
    return vec2f(ray.cell & field.wrap) + ray.origin.xy + 0.5 + ray.direction.xy * t;
}

/// How high the node under a ray is; above the coarsest level that one's. So much of the next level is mixed in.
fn quadtree_displacement_height(
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    t: f32,
    level: i32,
    next: f32,
) -> f32 {
    let texel = vec2i(floor(quadtree_displacement_place(field, ray, t)));
    let near = relief_bound(bounds, field, texel, min(level, field.top));
    if next == 0.0 {
        return near;
    }
    return mix(near, relief_bound(bounds, field, texel, min(level + 1i, field.top)), next);
}

/// More than RELIEF_NEVER: the plane is met inside of the node.
const QUADTREE_DISPLACEMENT_INSIDE: f32 = 2e30;

/// How far on the listing takes the border of the node at t to be, if the place at d is not in that node.
fn quadtree_displacement_border(
    field: ReliefField,
    ray: ReliefRay,
    t: f32,
    d: f32,
    level: i32,
    switches: QuadtreeDisplacementSwitches,
) -> f32 {
    let size = f32(1i << u32(min(level, field.top)));
    let start = quadtree_displacement_place(field, ray, 0.0);
    let at = quadtree_displacement_place(field, ray, t);
    let node = vec2i(at / size);
    // Levels above the coarsest have its nodes, and no borders where that is one node.
    let open = level > field.top && all((field.last >> vec2u(u32(field.top))) == vec2i(0));
    if open || all(node == vec2i(quadtree_displacement_place(field, ray, d) / size)) {
        return QUADTREE_DISPLACEMENT_INSIDE;
    }
    let tile = f32(1i << u32(field.top));
    let next = node + vec2i(sign(ray.direction.xy));
    let border = select(vec2f(next) * size, vec2f(next / vec2i(i32(tile / size))) * tile, switches.integers);
    let distance = quadtree_displacement_quotient(t * (border - start), at - start, switches.undefined);
    return min(distance.x, distance.y);
}

/// A quotient without its sign, where the divisor may be 0.
fn quadtree_displacement_quotient(over: vec2f, under: vec2f, undefined: f32) -> vec2f {
    let none = under == vec2f(0.0);
    let far = select(vec2f(RELIEF_NEVER), vec2f(undefined), over == vec2f(0.0));
    return select(abs(over / select(under, vec2f(1.0), none)), far, none);
}

/// Nodes after which a search is ended: as many more as the view is more level, but never fewer than there are levels.
fn quadtree_displacement_cap(field: ReliefField, ray: ReliefRay, switches: QuadtreeDisplacementSwitches) -> u32 {
    if switches.caps.y <= 0.0 {
        return 0xffffffffu;
    }
    let view = vec3f(ray.direction.xy, ray.direction.z / switches.steep);
    let upright = abs(view.z) / max(length(view), RELIEF_LEAST);
    return u32(max(mix(switches.caps.y, switches.caps.x, upright), f32(field.top + 1i)));
}

/// Where the ray meets the line through the heights a texel before and a texel behind.
fn quadtree_displacement_refined(heights: texture_2d_array<u32>, field: ReliefField, ray: ReliefRay, t: f32) -> f32 {
    let near = max(t - 1.0, 0.0);
    let far = min(t + 1.0, ray.end);
    let gaps = vec2f(linear_gap(heights, field, ray, near), linear_gap(heights, field, ray, far));
    return linear_refined(heights, field, ray, vec2f(near, far), gaps, 0u);
}
