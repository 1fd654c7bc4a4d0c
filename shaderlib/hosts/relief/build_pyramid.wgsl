//! Levels of a pyramid that is made on the device: the largest heights, or the smallest.

/// Whether nodes bound the surface from below.
override build_is_lowest: bool = false;

/// Whether heights are the bits of floats.
override build_is_float: bool = false;

/// A whole number that is the larger the higher a height is. Floats are compared by their bits: a device may take the smallest
/// for 0 where it calculates with them.
fn build_order(height: u32) -> u32 {
    let sign = 0x80000000u;
    // Zero has two signs and is one height.
    if !build_is_float || height == sign {
        return height;
    }
    return select(height | sign, ~height, (height & sign) != 0u);
}

/// The one of two heights that bounds both, the first if they are alike.
fn build_bound(a: u32, b: u32) -> u32 {
    let a_order = build_order(a);
    let b_order = build_order(b);
    return select(a, b, select(b_order > a_order, b_order < a_order, build_is_lowest));
}

/// The bound of four heights, in the order in which the host takes them.
fn build_bound_of(near: vec2i, far: vec2i) -> u32 {
    let left = build_bound(build_texel(near), build_texel(vec2i(near.x, far.y)));
    let right = build_bound(build_texel(vec2i(far.x, near.y)), build_texel(far));
    return build_bound(left, right);
}

/// The bound of the surface over each cell: that of its corners, of which those beyond the map are the first again.
@fragment
fn build_cells(@builtin(position) position: vec4f) -> @location(0) u32 {
    let at = build_place(position);
    return build_bound_of(at, (at + 1i) % build_part.size);
}

/// The bound of each node: that of its four children, or of what there is of them at the border.
@fragment
fn build_nodes(@builtin(position) position: vec4f) -> @location(0) u32 {
    let at = 2i * build_place(position);
    return build_bound_of(at, min(at + 1i, build_part.size - 1i));
}
