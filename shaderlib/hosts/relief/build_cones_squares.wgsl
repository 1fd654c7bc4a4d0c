//! The largest heights of squares that begin at each node of a level, made on the device for cones: layer k of a table has those
//! of 2^k nodes a side. Around the level there is what lies beyond its border, since squares begin and end there.

/// Nodes of the table before the first of the level.
override build_around: i32 = 33;

/// Whether what lies beyond the border is the map again. If not it is nothing: 0, as no height is lower.
override build_wraps: bool = false;

/// A level and what is around it.
@fragment
fn build_surrounded(@builtin(position) position: vec4f) -> @location(0) u32 {
    let size = build_part.size;
    let at = vec2i(position.xy) - build_around;
    if build_wraps {
        return build_texel((at % size + size) % size);
    }
    return select(0u, build_texel(clamp(at, vec2i(0), size - 1i)), all(at >= vec2i(0)) && all(at < size));
}

/// Squares of twice the side, of four each. Those that reach beyond the table's end are asked by nobody.
@fragment
fn build_joined(@builtin(position) position: vec4f) -> @location(0) u32 {
    let near = vec2i(position.xy);
    let far = min(near + build_part.first, build_part.size - 1i);
    let above = max(build_texel(near), build_texel(vec2i(far.x, near.y)));
    return max(above, max(build_texel(vec2i(near.x, far.y)), build_texel(far)));
}

/// The coarse map over nodes: at each corner the largest of those that meet there.
@fragment
fn build_corners(@builtin(position) position: vec4f) -> @location(0) u32 {
    let size = build_part.size;
    let at = vec2i(position.xy);
    let before = select(max(at - 1i, vec2i(0)), (at + size - 1i) % size, build_wraps);
    return build_bound_of(before, min(at, size - 1i));
}
