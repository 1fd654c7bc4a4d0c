//! A texture laid on from above and from both sides, so that cliffs do not smear.
//! Sides that count for less than 1/64 are not read.
//! Source: Geiss, "Generating Complex Procedural Terrains Using the GPU", GPU Gems 3, 2007, section 1.5 (triplanar texturing).

/// triplanar(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(0.5, 9.0, 1.5), vec3f(0.0), vec3f(0.0)), vec3f(0.0, 1.0, 0.0), 4.0, 4.0) == vec4f(0.0, 0.3333333, 1.0, 1.0) +- 0.01
/// triplanar(example_texture, example_sampler, 0, Place(vec2i(0, 0), vec3f(9.0, -1.5, 3.5), vec3f(0.0), vec3f(0.0)), vec3f(1.0, 0.0, 0.0), 4.0, 4.0) == vec4f(1.0, 0.3333333, 0.0, 1.0) +- 0.01
/// -> Colours are linear Rec. 709. 0..1
fn triplanar(
    /// What to read.
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
) -> vec4f {
    let weights = triplanar_weights(normal, sharpness);
    var color = vec4f(0.0);
    if (weights.x > 0.0) {
        let uv = triplanar_east(position, tile);
        color += weights.x * textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
    }
    if (weights.y > 0.0) {
        let uv = place_coord(position, tile);
        color += weights.y * textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
    }
    if (weights.z > 0.0) {
        let uv = triplanar_south(position, tile);
        color += weights.z * textureSampleGrad(of_texture, of_sampler, uv.uv, of_layer, uv.ddx, uv.ddy);
    }
    return saturate(color);
}

/// How much the views along x, y and z count; they sum to 1.
///
/// The largest component is scaled to 1 before the power, so the sum is at least 1 - 1/64; a normal of 0 counts as upright.
fn triplanar_weights(normal: vec3f, sharpness: f32) -> vec3f {
    let a = abs(normal);
    let largest = max(a.x, max(a.y, a.z));
    let scaled = select(vec3f(0.0, 1.0, 0.0), a / max(largest, 1e-6), largest > 1e-6);
    let powered = pow(max(scaled, vec3f(1e-3)), vec3f(sharpness));
    let kept = max(powered - 0.015625, vec3f(0.0));
    return kept / (kept.x + kept.y + kept.z);
}

/// Seen along x: u runs south, v down.
fn triplanar_east(position: Place, tile: f32) -> Coord {
    let uv = place_coord(position, tile);
    let rise = vec3f(position.local.y, position.ddx.y, position.ddy.y) / tile;
    return Coord(vec2f(uv.uv.y, -rise.x), vec2f(uv.ddx.y, -rise.y), vec2f(uv.ddy.y, -rise.z));
}

/// Seen along z: u runs east, v down.
fn triplanar_south(position: Place, tile: f32) -> Coord {
    let uv = place_coord(position, tile);
    let rise = vec3f(position.local.y, position.ddx.y, position.ddy.y) / tile;
    return Coord(vec2f(uv.uv.x, -rise.x), vec2f(uv.ddx.x, -rise.y), vec2f(uv.ddy.x, -rise.z));
}
