//! A normal from the heights of a relief, wherever its coordinates come from: what a surface with relief has where it says none.
//!
//! How height and place change from pixel to pixel gives the slope along the ground: no tile's side has to be known, and
//! coordinates may be turned and stretched.
//! Source: Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", Journal of Graphics, GPU, and Game Tools, 2010; the heights as `normal_from_height` reads them.

/// normal_from_relief(example_texture, example_sampler, 0, Coord(vec2f(0.375, 0.375), vec2f(0.01, 0.0), vec2f(0.0, 0.01)), Place(vec2i(0), vec3f(0.0), vec3f(0.01, 0.0, 0.0), vec3f(0.0, 0.0, 0.01)), vec3f(0.0, 1.0, 0.0), 0.75, 0) == vec3f(-0.7071068, 0.0, 0.7071068) +- 0.01
/// normal_from_relief(example_texture, example_sampler, 0, Coord(vec2f(0.375, 0.375), vec2f(0.01, -0.005), vec2f(0.005, 0.005)), Place(vec2i(0), vec3f(0.0), vec3f(0.01, 0.0, 0.02), vec3f(-0.01, 0.0, 0.01)), vec3f(0.0, 1.0, 0.0), 0.75, 0) == vec3f(0.0, -0.4472136, 0.8944272) +- 0.01
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn normal_from_relief(
    /// Heights 0..1.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where to read it.
    uv: Coord,
    /// The place of those coordinates.
    position: Place,
    /// The ground's normal in world space, y up. -1..1 = (0.0, 1.0, 0.0)
    ground: vec3f,
    /// Height that white stands for. [m] 0..1000 = 0.1
    depth: f32,
    /// The texture's channel: red, green, blue or alpha. const 0..3 = 0
    channel: u32,
) -> vec3f {
    let rise = normal_from_height_rise(of_texture, of_sampler, of_layer, uv, channel) * depth;
    let n = unit_vector_or(ground, vec3f(0.0, 1.0, 0.0));
    let right = dot(rise, uv.ddx) * cross(position.ddy, n);
    let down = dot(rise, uv.ddy) * cross(n, position.ddx);
    let facing = dot(n, cross(position.ddx, position.ddy));
    // Seen along the ground a pixel has no extent, and nothing is known.
    let known = abs(facing) > 1e-20;
    let slope = select(vec3f(0.0), (right + down) / select(1.0, facing, known), known);
    let tangent = normal_to_world(vec3f(1.0, 0.0, 0.0), n);
    let bitangent = normal_to_world(vec3f(0.0, 1.0, 0.0), n);
    return layer_normal(-vec2f(dot(slope, tangent), dot(slope, bitangent)));
}
