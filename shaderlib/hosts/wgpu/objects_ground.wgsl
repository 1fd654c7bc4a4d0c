//! The ground under solids.

/// A place of the height map: texel, what is left to the place, and both over the whole map.
struct HostUnder { texel: vec2i, part: vec2f, uv: vec2f }

/// Shares of the sun and of the sky that relief leaves to a place on an object.
struct HostSunk { sun: f32, open: f32 }

/// What lies under a place `at` metres from the eye.
fn host_under(at: vec3f) -> HostUnder {
    let away = (host_view.eye_offset + at.xz) / host_view.spacing;
    let whole = floor(away);
    let texel = host_view.eye_texel + vec2i(whole);
    let uv = (vec2f(texel) + (away - whole) + 0.5) / vec2f(textureDimensions(host_height));
    return HostUnder(texel, away - whole, uv);
}

/// Metres from height 0 to the bilinear surface of the height map.
fn host_ground_height(under: HostUnder) -> f32 {
    let last = vec2i(textureDimensions(host_height)) - 1i;
    let low = clamp(under.texel, vec2i(0i), last);
    let high = clamp(under.texel + 1i, vec2i(0i), last);
    let north = mix(
        textureLoad(host_height, low, 0i).r,
        textureLoad(host_height, vec2i(high.x, low.y), 0i).r,
        under.part.x,
    );
    let south = mix(
        textureLoad(host_height, vec2i(low.x, high.y), 0i).r,
        textureLoad(host_height, high, 0i).r,
        under.part.x,
    );
    return mix(north, south, under.part.y);
}
