//! A normal map laid on from above and from both sides, bent onto the ground: the partner of `triplanar`.
//! Source: Golus, "Normal Mapping for a Triplanar Shader", 2017 (whiteout blend of swizzled normals).

/// triplanar_normal(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(0.5, 9.0, 1.5), vec3f(0.0), vec3f(0.0)), vec3f(0.0, 1.0, 0.0), 4.0, 4.0, 0.0) == vec3f(0.0, 0.0, 1.0) +- 1e-5
/// triplanar_normal(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(0.5, 9.0, 1.5), vec3f(0.0), vec3f(0.0)), vec3f(0.0, 1.0, 0.0), 4.0, 4.0, 1.0) == vec3f(-0.6882472, -0.2294157, 0.6882472) +- 0.01
/// -> Unit length, relative to the ground; x east, y south, z out of it. -1..1
fn triplanar_normal(
    /// A normal map whose green channel points down the image.
    of_texture: texture_2d_array<f32>,
    of_sampler: sampler,
    of_layer: i32,
    /// Where.
    position: Place,
    /// The ground's, in world space, y up. -1..1
    normal: vec3f,
    /// Side of one tile. [m] 0.01..16384 = 4.0
    tile: f32,
    /// How quickly one side hands over to the next. 1..16 = 4.0
    sharpness: f32,
    /// Factor on the tilt. 0..4 = 1.0
    strength: f32,
) -> vec3f {
    let weights = triplanar_weights(normal, sharpness);
    // Each view tilts the ground's normal in its own plane; the component along the view stays.
    var bent = vec3f(0.0);
    if (weights.x > 0.0) {
        let uv = triplanar_east(position, tile);
        let texel = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
        let n = normal_map(texel, strength, 0.0);
        bent += weights.x * vec3f(n.z * normal.x, normal.y - n.y, normal.z + n.x);
    }
    if (weights.y > 0.0) {
        let uv = place_coord(position, tile);
        let texel = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
        let n = normal_map(texel, strength, 0.0);
        bent += weights.y * vec3f(normal.x + n.x, n.z * normal.y, normal.z + n.y);
    }
    if (weights.z > 0.0) {
        let uv = triplanar_south(position, tile);
        let texel = textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
        let n = normal_map(texel, strength, 0.0);
        bent += weights.z * vec3f(normal.x + n.x, normal.y - n.y, n.z * normal.z);
    }
    return normal_to_tangent(bent, normal);
}
