//! Hard shadow over a pyramid of sixteen children to a node: as `shadow_hard`, with fewer loads.
//!
//! It begins in the finest node around the point, which bounds the sixteen cells around it with one load.
//! Source: Terrane; see `wide` and `shadow_hard`.

/// What stands first in the way of a ray to the light; RELIEF_MISS where the light is seen.
fn shadow_wide_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    return wide_from(heights, bounds, field, ray, 1i);
}
