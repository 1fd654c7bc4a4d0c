//! The stride over cones that only what lies ahead narrows: four to a cell, one for each quadrant of directions, loaded at once.
//!
//! A tenth to three tenths fewer steps on rough ground than with one cone for all directions, for twice the memory. Exact for the reasons of
//! `robust_cone`: a ray stays in its quadrant.
//! Source: Terrane; see `robust_cone`; cones by sectors after Paglieroni, "The Directional Parameter Plane Transform of a Height Field", ACM Transactions on Graphics, 1998.

/// The first hit of a ray.
fn stride_quadrants_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    return stride_search(heights, bounds, field, ray, true);
}

/// The cone of a texel toward a ray that is mirrored so: the height of its tip, and how steep it is.
fn stride_quadrants_of(words: vec2u, mirror: vec2i) -> vec2f {
    let word = select(words.x, words.y, mirror.y != 0i);
    // Twelve bits toward larger x, twelve toward smaller: five of exponent, from 2^-14, and seven of mantissa.
    let code = (word >> (u32(mirror.x) & 12u)) & 0xfffu;
    return vec2f(f32((words.x >> 24u) | ((words.y >> 24u) << 8u)), bitcast<f32>((code << 16u) + 0x38800000u));
}
