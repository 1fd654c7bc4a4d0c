//! Soft shadow of a sun with a disc: the share of the disc that is seen, sharp where the blocker is near and soft where it is
//! far.
//!
//! The disc is cut into vertical chords, and each is seen above the horizon of its own vertical plane. The search begins at the
//! chord's lower end and stops at its upper one: most points cost little more than a hard shadow. One plane takes its horizon
//! as a level line before the whole disc, which is right for the sun; several are for wider lights.
//! Where a node is smaller than the cone, as `coarse` says, it is taken by its bound: the shadow is then too dark, if anything.
//! Source: Terrane; cones after Crassin et al., "Interactive Indirect Illumination Using Voxel Cone Tracing", Pacific Graphics 2011; chords by Gauss's rule for a weight of √(1 - x²) (Abramowitz and Stegun, 1964, 25.4.40).

/// The share of the disc. The ray starts above the ground and leads to the disc's middle; what is beyond its end casts no
/// shadow. `steps` of height are as long as a texel is wide, `radius` is the tangent of the disc's, `lid` the highest height of
/// the map. `own` are the heights of the cell that it starts in. `planes` is at least 1; `coarse` counts in radii of the cone, 0 for exact horizons.
fn shadow_cone_share(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    own: vec4f,
    steps: f32,
    radius: f32,
    lid: f32,
    planes: u32,
    coarse: f32,
) -> ShadowSeen {
    let tangent = ray.direction.z / (length(ray.direction.xy) * steps);
    let aside = radius * sqrt(1.0 + tangent * tangent);
    var seen = ShadowSeen(0.0, RELIEF_HIT, 0u, 0u);
    for (var plane = 1u; plane <= planes; plane++) {
        let angle = f32(plane) * (3.14159265 / f32(planes + 1u));
        let half = sin(angle);
        let way = shadow_cone_way(ray.direction.xy, select(aside * cos(angle), 0.0, planes == 1u));
        let unit = length(way) * steps;
        let low = unit * max(shadow_cone_tangent(tangent, -half * radius), 0.0);
        let high = unit * shadow_cone_tangent(tangent, half * radius);
        let chord = ReliefRay(ray.cell, ray.origin, vec3f(way, low), ray.end);
        let sent = ReliefRay(ray.cell, ray.origin, chord.direction, shadow_end(field, chord));
        let found = horizon_search(heights, bounds, field, sent, own, high, lid, coarse * radius, 0.0);
        let slope = found.slope / unit;
        let line = (slope - tangent) / ((1.0 + slope * tangent) * radius);
        let part = select(saturate((half - line) / (2.0 * half)), shadow_disc(line), planes == 1u);
        seen.share += part * select(2.0 * half * half / f32(planes + 1u), 1.0, planes == 1u);
        seen.state = select(RELIEF_UNRESOLVED, seen.state, found.done);
        seen.steps += found.steps;
        seen.leaves += found.leaves;
    }
    return seen;
}

/// A direction turned by an angle with this tangent; the larger of |x| and |y| is 1 again.
fn shadow_cone_way(direction: vec2f, aside: f32) -> vec2f {
    let turned = direction + aside * vec2f(-direction.y, direction.x);
    return turned / max(abs(turned.x), abs(turned.y));
}

/// The tangent of the sum of two angles, of which the second is small; so high that nothing reaches it from the zenith on.
fn shadow_cone_tangent(tangent: f32, offset: f32) -> f32 {
    return (tangent + offset) / max(1.0 - tangent * offset, 1e-4);
}
