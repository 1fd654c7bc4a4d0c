//! Cone step mapping, as published: from where the ray is, it goes to where it leaves the cone over that place. Each texel's
//! cone is free of all other texels; between texels height and ratio are filtered, and nothing says that this cone is free too.
//! A sample reads four texels here; a filtered texture would be read once.
//! Source: Dummer, "Cone Step Mapping: An Iterative Ray-Heightfield Intersection Algorithm", 2006: the loop of so many steps, and the exact one.

/// The hit that cone steps lead to. So many `steps` are taken, and where they end is the hit, whether the ground is there or
/// not; with 0 steps it goes on until it is in the ground, each time a texel farther than the cone, and then back that texel. The
/// heights are not read: they stand beside the cones.
fn cone_step_trace(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    steps: u32,
) -> ReliefHit {
    let across = length(ray.direction.xy);
    // A vertical ray crosses no texel.
    let texel = select(0.0, 1.0 / max(across, 1e-6), across > 1e-6);
    var t = 0.0;
    if steps > 0u {
        for (var step = 0u; step < steps; step++) {
            t = clamp(t + cone_step_length(cone_step_sample(bounds, field, ray, t), ray, across, t), 0.0, ray.end);
        }
        return ReliefHit(t, select(RELIEF_HIT, RELIEF_MISS, t >= ray.end), cone_step_cell(ray, t), steps, 0u);
    }
    for (var step = 1u; step <= field.limit; step++) {
        let ground = cone_step_sample(bounds, field, ray, t);
        if ray.origin.z + ray.direction.z * t <= ground.x {
            let back = max(t - texel, 0.0);
            return ReliefHit(back, RELIEF_HIT, cone_step_cell(ray, back), step, 0u);
        }
        if t >= ray.end {
            return ReliefHit(ray.end, RELIEF_MISS, vec2i(0), step, 0u);
        }
        t = min(t + texel + cone_step_length(ground, ray, across, t), ray.end);
    }
    return ReliefHit(t, RELIEF_UNRESOLVED, vec2i(0), field.limit, 0u);
}

/// The cell under the ray.
fn cone_step_cell(ray: ReliefRay, t: f32) -> vec2i {
    return ray.cell + vec2i(floor(ray.origin.xy + ray.direction.xy * t));
}

/// How far the ray stays in the cone over the place that it has reached; negative where it is in the ground.
fn cone_step_length(ground: vec2f, ray: ReliefRay, across: f32, t: f32) -> f32 {
    let above = ray.origin.z + ray.direction.z * t - ground.x;
    let closing = across - ray.direction.z * ground.y;
    // A ray that rises as steeply as the cone never leaves it.
    return select(ray.end, above * ground.y / max(closing, 1e-6), closing > 1e-6);
}

/// Height and ratio under the ray, between the four texels there.
fn cone_step_sample(
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    t: f32,
) -> vec2f {
    let at = ray.origin.xy + ray.direction.xy * t;
    let whole = floor(at);
    let part = at - whole;
    let cell = ray.cell + vec2i(whole);
    let near = mix(
        cone_step_texel(bounds, field, cell),
        cone_step_texel(bounds, field, cell + vec2i(1, 0)),
        part.x,
    );
    let far = mix(
        cone_step_texel(bounds, field, cell + vec2i(0, 1)),
        cone_step_texel(bounds, field, cell + 1i),
        part.x,
    );
    return mix(near, far, part.y);
}

/// The height of a texel, and how many texels its cone is wide a step above it.
fn cone_step_texel(bounds: texture_2d_array<u32>, field: ReliefField, texel: vec2i) -> vec2f {
    let cone = textureLoad(bounds, min(texel & field.wrap, field.last), field.layer, field.mip).rg;
    // Five bits of exponent, from 2^-18, and eleven of mantissa.
    return vec2f(f32(cone.x), bitcast<f32>((cone.y << 12u) + 0x36800000u));
}
