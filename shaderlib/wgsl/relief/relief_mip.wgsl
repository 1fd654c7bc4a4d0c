//! Heights between texels and between mips, filtered by hand: textures of whole numbers have no filter. Not a node.
//! Source: Terrane.

/// The height of mip 0 at a place in a cell, or of coarser mips, linear between texels and mips. A map that ends has one mip.
fn relief_mip_height(heights: texture_2d_array<u32>, field: ReliefField, cell: vec2i, place: vec2f, level: f32) -> f32 {
    let last = f32(textureNumLevels(heights) - 1u);
    let mip = clamp(level, 0.0, last);
    let finer = relief_mip_texels(heights, field, cell, place, i32(mip));
    let part = fract(mip);
    if part == 0.0 {
        return finer;
    }
    return mix(finer, relief_mip_texels(heights, field, cell, place, i32(mip) + 1i), part);
}

/// The same on one mip. A texel of it stands in the middle of those that it covers.
fn relief_mip_texels(heights: texture_2d_array<u32>, field: ReliefField, cell: vec2i, place: vec2f, mip: i32) -> f32 {
    let shift = vec2u(u32(mip));
    let side = f32(1i << u32(mip));
    // Whole cells apart from fractions, so that no place is too far away.
    let whole = cell + vec2i(floor(place));
    let inner = vec2f(whole - ((whole >> shift) << shift)) + fract(place);
    let at = (inner + 0.5) / side - 0.5;
    let near = (whole >> shift) + vec2i(floor(at));
    let part = at - floor(at);
    let corners = vec4f(
        relief_mip_texel(heights, field, near, mip),
        relief_mip_texel(heights, field, near + vec2i(1, 0), mip),
        relief_mip_texel(heights, field, near + vec2i(0, 1), mip),
        relief_mip_texel(heights, field, near + vec2i(1, 1), mip),
    );
    return relief_height(corners, part);
}

/// A texel of a mip; beyond the border of a map that ends, the nearest.
fn relief_mip_texel(heights: texture_2d_array<u32>, field: ReliefField, texel: vec2i, mip: i32) -> f32 {
    let shift = vec2u(u32(mip));
    let at = clamp(texel & (field.wrap >> shift), vec2i(0), field.last >> shift);
    return f32(textureLoad(heights, at, field.layer, mip).r);
}
