//! A normal from a height texture with eight samples: smoother and rounder than the cross of `normal_from_height`.
//! Source: Sobel and Feldman, "A 3x3 Isotropic Gradient Operator for Image Processing", 1968, in Duda and Hart, "Pattern Classification and Scene Analysis", 1973.

/// normal_sobel(example_texture, example_sampler, 0, Coord(vec2f(0.375, 0.375), vec2f(0.0), vec2f(0.0)), 0.75, 1.0) == vec3f(-0.7071068, 0.0, 0.7071068) +- 0.01
/// -> Unit length; x along u, y along v, z out of the ground. -1..1
fn normal_sobel(
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
    let reach = normal_from_height_reach(of_texture, uv);
    var rise = vec2f(0.0);
    for (var y = -1; y <= 1; y++) {
        for (var x = -1; x <= 1; x++) {
            if (x != 0 || y != 0) {
                let off = vec2f(vec2i(x, y));
                let h = textureSampleGrad(of_texture, of_sampler, uv.uv + off * reach, of_layer, uv.ddx, uv.ddy).r;
                // Weights 1, 2, 1 along the other axis.
                rise += h * off * (2.0 - abs(off.yx));
            }
        }
    }
    return layer_normal(-rise / (8.0 * reach) * (depth / max(tile, 0.01)));
}
