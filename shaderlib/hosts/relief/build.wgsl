//! Bounds and mips of a height map, made on the device: each pass draws one level from the one before it, in whole numbers, so
//! that what comes out is what the host makes, to the last bit. Passes draw, since a 16-bit whole number is a colour that core
//! WebGPU can draw and no texel that a compute pass can store; the rectangle that is brought up to date is the scissor's.

@group(0) @binding(0) var build_source: texture_2d<u32>;

/// 1 on each axis for a map that is traced tile by tile, whose first texels stand again at its end.
override build_seam: i32 = 0;

fn build_texel(at: vec2i) -> u32 {
    return textureLoad(build_source, at, 0i).r;
}

/// One triangle that covers the target.
@vertex
fn build_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(4.0 * f32(index & 1u) - 1.0, 4.0 * f32(index >> 1u) - 1.0, 0.0, 1.0);
}

/// The first mip from the map: beyond its last texel it is that one again.
@fragment
fn build_fill(@builtin(position) position: vec4f) -> @location(0) u32 {
    let size = vec2i(textureDimensions(build_source));
    return build_texel(min(vec2i(position.xy), size - 1i + build_seam) % size);
}

/// A mip from the one before it: the mean of the four texels that each covers, rounded.
@fragment
fn build_mip(@builtin(position) position: vec4f) -> @location(0) u32 {
    let at = 2i * vec2i(position.xy);
    let sum = build_texel(at) + build_texel(at + vec2i(1, 0)) + build_texel(at + vec2i(0, 1)) + build_texel(at + 1i);
    return (sum + 2u) >> 2u;
}

/// The largest height over each cell of a mip: the largest at its corners, of which those beyond the map are the first again.
@fragment
fn build_cells(@builtin(position) position: vec4f) -> @location(0) u32 {
    let last = vec2i(textureDimensions(build_source)) - 1i;
    let at = vec2i(position.xy);
    let next = (at + 1i) & last;
    let near = max(build_texel(at), build_texel(vec2i(next.x, at.y)));
    return max(near, max(build_texel(vec2i(at.x, next.y)), build_texel(next)));
}

/// The largest height over each node from those of its four children.
@fragment
fn build_nodes(@builtin(position) position: vec4f) -> @location(0) u32 {
    let at = 2i * vec2i(position.xy);
    let near = max(build_texel(at), build_texel(at + vec2i(1, 0)));
    return max(near, max(build_texel(at + vec2i(0, 1)), build_texel(at + 1i)));
}
