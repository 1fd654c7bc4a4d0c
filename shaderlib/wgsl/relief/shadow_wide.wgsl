//! Hard shadow over a pyramid of sixteen children to a node: as `shadow_hard`, with fewer loads.
//!
//! Behind its own cell, whose patch is known, it begins in the finest node around the ray, which bounds sixteen cells with one load.
//! Source: Terrane; see `wide` and `shadow_hard`.

/// What stands first in the way of a ray to the light; RELIEF_MISS where the light is seen. `own` are the heights of the cell
/// that it starts in, which who asks has for the point's own height.
fn shadow_wide_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    own: vec4f,
) -> ReliefHit {
    let frame = walk_frame(ray);
    let cell = WalkState(frame.base, 0i, 0.0, 0u, true, true);
    let t = walk_patch(frame, cell, relief_mirrored(own, frame.mirror));
    if t <= frame.end {
        return ReliefHit(t, RELIEF_HIT, ray.cell, 0u, 0u);
    }
    let past = walk_past(frame, field, cell);
    if past.t >= frame.end {
        return ReliefHit(frame.end, RELIEF_MISS, vec2i(0), 0u, 0u);
    }
    return wide_from(heights, bounds, field, frame, WideState(past.cell, 1i, past.t, false));
}
