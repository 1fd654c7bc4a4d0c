//! Entry points that put the depth of displaced surfaces in place of the ground's.

@group(0) @binding(0) var depth_displaced: texture_2d<f32>;

@vertex
fn depth_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(select(-1.0, 3.0, index == 1u), select(-1.0, 3.0, index == 2u), 0.0, 1.0);
}

@fragment
fn depth_fragment(@builtin(position) position: vec4f) -> @builtin(frag_depth) f32 {
    let depth = textureLoad(depth_displaced, vec2i(position.xy), 0i).r;
    if depth <= 0.0 {
        discard;
    }
    return depth;
}
