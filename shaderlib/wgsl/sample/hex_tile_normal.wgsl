//! A normal map without visible repetition: the partner of `hex_tile`, with the tilts turned back with their copies.
//! Source: Mikkelsen, "Practical Real-Time Hex-Tiling", JCGT 11(2), 2022, section on normal maps (blend as surface gradients).

/// hex_tile_normal(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(0.5, 9.0, 1.5), vec3f(0.0), vec3f(0.0)), 4.0, 0.5, 1.0, 0u, 0.0) == vec3f(0.0, 0.0, 1.0) +- 1e-6
/// -> Unit length; x east, y south, z out of the ground. -1..1
fn hex_tile_normal(
    /// A normal map whose green channel points down the image.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where.
    position: Place,
    /// Side of one tile. [m] 0.05..1024 = 4.0
    tile: f32,
    /// Distance between copies, in tiles: as for the colour. 0.1..4 = 0.5
    spacing: f32,
    /// How far a copy is turned at most: as for the colour. 0..1 = 1.0
    turning: f32,
    /// Another seed gives another arrangement: as for the colour. 0..65535 = 0
    seed: u32,
    /// Factor on the tilt. 0..4 = 1.0
    strength: f32,
) -> vec3f {
    let grid = hex_tile_grid(position, tile * spacing);
    var tilt = vec2f(0.0);
    var total = 0.0;
    for (var corner = 0; corner < 3; corner++) {
        let copy = hex_tile_copy(grid, corner, position, tile, turning, seed);
        let uv = copy.uv;
        let texel = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
        let weight = hex_tile_weight(copy.near, vec3f(1.0));
        let turned = layer_slopes(normal_map(texel, strength, 0.0));
        let back = mat2x2f(copy.turn.x, copy.turn.y, -copy.turn.y, copy.turn.x);
        tilt += weight * (back * turned);
        total += weight;
    }
    return layer_normal(tilt / max(total, 1e-5));
}
