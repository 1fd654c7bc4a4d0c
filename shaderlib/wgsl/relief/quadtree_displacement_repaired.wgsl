//! Quadtree displacement mapping made exact, with its own order of search: down by a level where the ray meets a node's bound,
//! up by one at every border. Its bounds are those of cells, its leaf is the patch, its nodes are whole numbers, and a search that
//! is given up says so.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro 1, 2010, listing 1.3, repaired.

/// The first hit of a ray; `bounds` over cells.
fn quadtree_displacement_repaired_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    return quadtree_trace(heights, bounds, field, ray, true);
}
