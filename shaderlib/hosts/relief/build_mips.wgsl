//! The heights of a map that is made on the device, and their mips.

/// 1 on each axis for a map that is traced tile by tile, whose first texels stand again at its end.
override build_seam: i32 = 0;

/// The first mip from the map: beyond its last texel it is that one again.
@fragment
fn build_fill(@builtin(position) position: vec4f) -> @location(0) u32 {
    let size = build_part.size;
    return build_texel(min(build_place(position), size - 1i + build_seam) % size);
}

/// A mip from the one before it: the mean of the four texels that each covers, rounded.
@fragment
fn build_mip(@builtin(position) position: vec4f) -> @location(0) u32 {
    let at = 2i * build_place(position);
    let sum = build_texel(at) + build_texel(at + vec2i(1, 0)) + build_texel(at + vec2i(0, 1)) + build_texel(at + 1i);
    return (sum + 2u) >> 2u;
}
