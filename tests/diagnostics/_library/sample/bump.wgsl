//! A normal from the red channel of a height map.
//! Source: test.

/// bump(example_texture, example_sampler, 0, Coord(vec2f(0.0), vec2f(0.0), vec2f(0.0))).x == 0.0 +- 1.0
/// -> The normal, in tangent space.
fn bump(
    /// What to read.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where to read.
    uv: Coord,
) -> vec3f {
    let height = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy).x;
    return vec3f(height, 0.0, 1.0);
}
