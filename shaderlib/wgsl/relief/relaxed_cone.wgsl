//! Relaxed cone stepping, as published: cones so wide that a ray may pierce the ground in them once, so many steps from cone to
//! cone until the ray is in the ground, and binary search between the last two places. Right over texels; over the filtered
//! heights that are traced it may still miss what is thin.
//! Source: Policarpo and Oliveira, "Relaxed Cone Stepping for Relief Mapping", GPU Gems 3, 2007, chapter 18.

/// The hit that so many relaxed cone `steps` and `halvings` lead to.
fn relaxed_cone_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    steps: u32,
    halvings: u32,
) -> ReliefHit {
    let across = length(ray.direction.xy);
    var near = 0.0;
    var far = 0.0;
    var taken = 0u;
    var under = false;
    loop {
        let ground = cone_step_sample(bounds, field, ray, far);
        taken++;
        under = ray.origin.z + ray.direction.z * far <= ground.x;
        if under || taken > steps || far >= ray.end {
            break;
        }
        near = far;
        far = min(far + cone_step_length(ground, ray, across, far), ray.end);
    }
    if !under {
        // Steps that do not suffice end in the air, and the published method takes that for the ground.
        let outcome = select(RELIEF_HIT, RELIEF_MISS, far >= ray.end);
        return ReliefHit(far, outcome, cone_step_cell(ray, far), taken, 0u);
    }
    for (var halving = 0u; halving < halvings; halving++) {
        let middle = 0.5 * (near + far);
        let deep = linear_gap(heights, field, ray, middle) <= 0.0;
        near = select(middle, near, deep);
        far = select(far, middle, deep);
    }
    return ReliefHit(far, RELIEF_HIT, cone_step_cell(ray, far), taken + halvings, 0u);
}
