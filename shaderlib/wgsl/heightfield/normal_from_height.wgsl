//! A normal from a height texture with four samples in a cross: the fastest, and good enough for most.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, listing 1 (filterNormal).

/// normal_from_height(example_texture, example_sampler, 0, Coord(vec2f(0.375, 0.375), vec2f(0.0), vec2f(0.0)), 0.75, 1.0) == vec3f(-0.7071068, 0.0, 0.7071068) +- 0.01
/// -> Unit length; x along u, y along v, z out of the ground. -1..1
fn normal_from_height(
    /// Heights 0..1 in red.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where to read it.
    uv: Coord,
    /// Height that white stands for. [m] 0..1000 = 0.1
    depth: f32,
    /// Side of one tile. [m] 0.01..16384 = 4.0
    tile: f32,
) -> vec3f {
    let rise = normal_from_height_rise(of_texture, of_sampler, of_layer, uv, 0u);
    return layer_normal(-rise * (depth / max(tile, 0.01)));
}

/// By how much of white a channel's heights rise to a tile along u and along v.
fn normal_from_height_rise(
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    uv: Coord,
    channel: u32,
) -> vec2f {
    let reach = normal_from_height_reach(of_texture, uv);
    let x = vec2f(reach.x, 0.0);
    let y = vec2f(0.0, reach.y);
    let rise = vec2f(
        textureSampleGrad(of_texture, of_sampler, uv.uv + x, of_layer, uv.ddx, uv.ddy)[channel]
            - textureSampleGrad(of_texture, of_sampler, uv.uv - x, of_layer, uv.ddx, uv.ddy)[channel],
        textureSampleGrad(of_texture, of_sampler, uv.uv + y, of_layer, uv.ddx, uv.ddy)[channel]
            - textureSampleGrad(of_texture, of_sampler, uv.uv - y, of_layer, uv.ddx, uv.ddy)[channel],
    );
    return rise / (2.0 * reach);
}

/// How far from the middle to sample, in tiles: a texel, or a pixel where that is larger, since nearer samples of a coarser mip hardly differ.
fn normal_from_height_reach(of_texture: texture_2d_array<f32>, uv: Coord) -> vec2f {
    let texel = 1.0 / vec2f(max(textureDimensions(of_texture), vec2u(1u)));
    return max(texel, vec2f(min(coord_footprint(uv), 0.25)));
}
