//! Wide nodes, made on the device from the largest heights over their sixteen children.

/// Steps of the map to a step of a base, bits of a child's own and of a base, as powers of two: a node's form is that of
/// `pyramid::Wide` over 16-bit heights.
const build_unit: u32 = 4u;
const build_own: u32 = 7u;
const build_base: u32 = 12u;

/// Each node in a strip that is broken into rows.
@fragment
fn build_wide(@builtin(position) position: vec4f) -> @location(0) vec4u {
    let strip = build_part.corner;
    let index = i32(position.y) * strip.y + i32(position.x) - strip.x;
    let columns = (build_part.size.x + 3i) / 4i;
    let node = vec2i(index % columns, index / columns);
    // A row of the target has nodes of other levels, and of others than are brought up to date.
    if any(node < build_part.first) || any(node >= build_part.behind) {
        discard;
    }
    return build_packed(build_row(node, 0), build_row(node, 1), build_row(node, 2), build_row(node, 3));
}

/// The heights over a row of children, less one: so they are rounded down, to be rounded up again by one more. A map of fewer
/// cells than children is repeated.
fn build_row(node: vec2i, row: i32) -> vec4u {
    let size = build_part.size;
    let y = (4i * node.y + row) % size.y;
    let x = (4i * vec4i(node.x) + vec4i(0, 1, 2, 3)) % vec4i(size.x);
    let near = vec2u(build_texel(vec2i(x.x, y)), build_texel(vec2i(x.y, y)));
    let far = vec2u(build_texel(vec2i(x.z, y)), build_texel(vec2i(x.w, y)));
    return max(vec4u(near, far), vec4u(1u)) - vec4u(1u);
}

/// A node: what is over its base, in steps that seven bits hold.
fn build_packed(a: vec4u, b: vec4u, c: vec4u, d: vec4u) -> vec4u {
    let lowest = min(min(a, b), min(c, d));
    let highest = max(max(a, b), max(c, d));
    let base = min(min(lowest.x, lowest.y), min(lowest.z, lowest.w)) >> build_unit;
    let low = base << build_unit;
    let over = max(max(highest.x, highest.y), max(highest.z, highest.w)) - low;
    let shift = max(32u - countLeadingZeros(over), build_own) - build_own;
    let header = base | (shift << build_base);
    return vec4u(
        build_word((a - low) >> vec4u(shift), header),
        build_word((b - low) >> vec4u(shift), header >> 4u),
        build_word((c - low) >> vec4u(shift), header >> 8u),
        build_word((d - low) >> vec4u(shift), header >> 12u),
    );
}

/// Four children's own bits, and as the highest bit of each of their bytes four of the node.
fn build_word(own: vec4u, header: u32) -> u32 {
    let high = (vec4u(header) >> vec4u(0u, 1u, 2u, 3u)) & vec4u(1u);
    let bytes = (own | (high << vec4u(build_own))) << vec4u(0u, 8u, 16u, 24u);
    return bytes.x | bytes.y | bytes.z | bytes.w;
}
