//! Hard shadow: whether anything stands between a point and the light.
//!
//! Exact for the ray that it is given, but for rounding: what the ray passes by more than a step of height (2^-16 of the depth
//! of a 16-bit map) is seen as it is. The ground is solid, and a ray that starts on it is in its own shadow: lift it a little
//! (`shadow_ray`). Ask only where the light is in front of the surface.
//! Source: Terrane; after Tevs, Ihrke and Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering", I3D 2008; the test for shadow after Policarpo, Oliveira and Comba, "Real-Time Relief Mapping on Arbitrary Polygonal Surfaces", I3D 2005.

/// What stands first in the way of a ray to the light; RELIEF_MISS where the light is seen. `own` are the heights of the cell
/// that it starts in, which who asks has for the point's own height.
fn shadow_hard_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    own: vec4f,
) -> ReliefHit {
    let frame = walk_frame(ray);
    var state = climb_start(frame);
    var corners = relief_mirrored(own, frame.mirror);
    var leaves = 0u;
    while state.stands {
        let sides = state.node.sides;
        let at = frame.origin + frame.direction * state.t;
        let place = vec3f(at.xy - (sides - 1.0), at.z);
        let t = state.t + relief_patch(corners, place, frame.direction, state.leave - state.t);
        if t <= frame.end {
            return ReliefHit(t, RELIEF_HIT, climb_cell(frame, state.node) ^ frame.mirror, state.steps, leaves);
        }
        state = climb_on(bounds, field, frame, state, 0.0);
        if state.stands {
            leaves++;
            corners = relief_corners(heights, field, climb_cell(frame, state.node), frame.mirror);
        }
    }
    let outcome = select(RELIEF_UNRESOLVED, RELIEF_MISS, state.t >= frame.end);
    return ReliefHit(min(state.t, frame.end), outcome, vec2i(0), state.steps, leaves);
}
