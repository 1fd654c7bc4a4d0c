//! The walk with the least work to a load, for devices where arithmetic is dear: bounds and patches are storage textures, which
//! have no mips to look up each time, and the four heights of a patch are one texel.
//!
//! It visits the nodes that `walk` visits, and is exact for the same reasons.
//! Source: Terrane; see `walk`.

/// The first hit of a ray. A texel of `patches` holds the four heights of a cell, two to a word.
fn sprint_trace(
    patches: texture_storage_2d_array<rg32uint, read>,
    bounds: texture_storage_2d_array<r32uint, read>,
    field: ReliefField,
    ray: ReliefRay,
) -> ReliefHit {
    let frame = walk_frame(ray);
    var state = WalkState(frame.base, min(walk_entry(ray.end), field.top), 0.0, 0u, false, false);
    var leaves = 0u;
    loop {
        state = sprint_to_cell(bounds, field, frame, state);
        if !state.stands {
            break;
        }
        leaves++;
        let t = walk_patch(frame, state, sprint_corners(patches, field, state.cell, frame.mirror));
        if t <= frame.end {
            return ReliefHit(t, RELIEF_HIT, state.cell ^ frame.mirror, state.steps, leaves);
        }
        state = walk_past(frame, field, state);
        if state.t >= frame.end || state.steps >= field.limit {
            break;
        }
    }
    let outcome = select(RELIEF_UNRESOLVED, RELIEF_MISS, state.t >= frame.end);
    return ReliefHit(min(state.t, frame.end), outcome, vec2i(0), state.steps, leaves);
}

/// Goes on until it stands on a cell that may be hit, is past the end, or has seen too many nodes.
fn sprint_to_cell(
    bounds: texture_storage_2d_array<r32uint, read>,
    field: ReliefField,
    frame: WalkFrame,
    start: WalkState,
) -> WalkState {
    var state = start;
    loop {
        let texel = (((state.cell ^ frame.mirror) & field.wrap) + field.corner) >> vec2u(u32(state.level));
        state = walk_step(frame, field, state, f32(i32(textureLoad(bounds, texel, field.layer).r)));
        if state.rests {
            break;
        }
    }
    return state;
}

/// The four heights of a cell in the mirrored frame: at its corner, one along x, one along y, and both.
fn sprint_corners(
    patches: texture_storage_2d_array<rg32uint, read>,
    field: ReliefField,
    cell: vec2i,
    mirror: vec2i,
) -> vec4f {
    let words = vec2i(textureLoad(patches, ((cell ^ mirror) & field.wrap) + field.patches, field.layer).rg);
    let low = words & vec2i(0xffffi);
    let high = (words >> vec2u(16u)) & vec2i(0xffffi);
    return relief_mirrored(vec4f(vec4i(low.x, high.x, low.y, high.y)), mirror);
}
