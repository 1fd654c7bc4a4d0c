//! Patches of a height map, made on the device.

/// The four heights of each cell: to the corner, along x in the high half, the row behind in the second word. Behind the last
/// texel is the first again where the map wraps, else the last once more. In both halves of a target: one is masked where the other
/// holds cones.
@fragment
fn build_patches(@builtin(position) position: vec4f) -> @location(0) vec4u {
    let near = build_place(position);
    let far = select(min(near + 1i, build_part.size - 1i), (near + 1i) % build_part.size, vec2<bool>(build_wraps));
    let low = vec2u(build_texel(near), build_texel(vec2i(near.x, far.y)));
    let high = vec2u(build_texel(vec2i(far.x, near.y)), build_texel(far));
    return (low | (high << vec2u(16u))).xyxy;
}
