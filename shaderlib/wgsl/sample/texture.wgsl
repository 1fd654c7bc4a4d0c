//! The colour or value of a texture, filtered for the size of the pixel.
//! Source: W3C, "WebGPU Shading Language", section 17.7 (textureSampleGrad).

/// texture(example_texture, example_sampler, 0, Coord(vec2f(0.125, 0.125), vec2f(0.0), vec2f(0.0))) == vec4f(0.0, 0.0, 0.0, 1.0) +- 0.01
/// texture(example_texture, example_sampler, 0, Coord(vec2f(0.875, 0.375), vec2f(0.0), vec2f(0.0))) == vec4f(1.0, 0.3333333, 0.0, 1.0) +- 0.01
/// -> Colours are linear Rec. 709. 0..1
fn texture(
    /// What to read.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where to read it.
    uv: Coord,
) -> vec4f {
    return textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
}
