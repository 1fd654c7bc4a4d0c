//! Mips and bounds of a height map, made on the device: each pass draws one level from the one before it, in whole numbers, so
//! that what comes out is what the host makes, to the last bit. Passes draw, since a 16-bit whole number is a colour that core
//! WebGPU can draw and no texel that a compute pass can store; the rectangle that is brought up to date is the scissor's, and of cones
//! it is the parts that `build_part_vertex` leaves.

@group(0) @binding(0) var build_source: texture_2d<u32>;
@group(0) @binding(1) var<uniform> build_part: BuildPart;

/// What a pass reads, and where it draws.
struct BuildPart {
    /// Columns and rows of what is read: from there on a texture may have texels that mean nothing.
    size: vec2i,
    /// The texel of the target that is the first of the level. For wide nodes: its number, and the columns of the target.
    corner: vec2i,
    /// The first of the wide nodes that are drawn, or of the nodes whose highest is drawn, and what is behind the last of them. Of
    /// squares that are joined `first` is how far apart they begin; where parts are drawn `behind` is the columns and rows of the level.
    first: vec2i,
    behind: vec2i,
}

fn build_texel(at: vec2i) -> u32 {
    return textureLoad(build_source, at, 0i).r;
}

/// The texel of the level that is drawn.
fn build_place(position: vec4f) -> vec2i {
    return vec2i(position.xy) - build_part.corner;
}

/// One triangle that covers the target.
@vertex
fn build_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(4.0 * f32(index & 1u) - 1.0, 4.0 * f32(index >> 1u) - 1.0, 0.0, 1.0);
}

/// A level as it is, where it belongs in an image of several.
@fragment
fn build_same(@builtin(position) position: vec4f) -> @location(0) u32 {
    return build_texel(build_place(position));
}
