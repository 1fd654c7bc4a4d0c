//! Entry points for terrain: a grid of 33 × 33 vertices per patch, lifted by the height map.
//!
//! Patches around the terrain are mirror images of it. `texel` counts in the height map, `unfolded` in the row of images.

struct HostPatch {
    /// Texel of the first corner.
    @location(1) texel: vec2i,
    /// Where that texel lies in the row of images.
    @location(2) unfolded: vec2i,
    /// Texels between vertices; negative where the image is mirrored.
    @location(3) stride: vec2i,
    /// The corner's x and z in 1/256 m.
    @location(4) origin: vec2i,
    /// Metres from there to the corner, below 1/256.
    @location(5) rest: vec2f,
}

struct HostVertex {
    // The pre-pass must land on the same depth, bit for bit.
    @builtin(position) @invariant clip: vec4f,
    /// Metres from the patch's origin; y is the height.
    @location(0) local: vec3f,
    @location(1) @interpolate(flat) texel: vec2i,
    @location(2) @interpolate(flat) unfolded: vec2i,
    /// 1 or -1.
    @location(3) @interpolate(flat) mirror: vec2f,
    @location(4) @interpolate(flat) origin: vec2i,
    @location(5) @interpolate(flat) rest: vec2f,
}

@vertex
fn terrain_vertex(@location(0) corner: vec2u, tile: HostPatch) -> HostVertex {
    let last = vec2i(textureDimensions(host_height)) - 1i;
    // The terrain ends inside a patch: what lies beyond shrinks to its border.
    let steps = min(vec2i(corner) * abs(tile.stride), last - tile.texel);
    let height = textureLoad(host_height, tile.texel + steps, 0i).r;
    let unfolded = tile.unfolded + steps * sign(tile.stride);
    let local = tile.rest + vec2f(unfolded - tile.unfolded) * host_view.spacing;
    // From whole texels, so that patches that share a vertex agree on it to the last bit.
    let flat = vec2f(unfolded - host_view.eye_texel) * host_view.spacing - host_view.eye_offset;
    var vertex: HostVertex;
    vertex.clip = host_view.clip * vec4f(flat.x, height - host_view.eye_height, flat.y, 1.0);
    vertex.local = vec3f(local.x, height, local.y);
    vertex.texel = tile.texel;
    vertex.unfolded = tile.unfolded;
    vertex.mirror = vec2f(sign(tile.stride));
    vertex.origin = tile.origin;
    vertex.rest = tile.rest;
    return vertex;
}

/// A place of the terrain under a pixel.
struct HostPlace {
    frame: HostFrame,
    /// Metres over the whole terrain on x and z, negative where the image is mirrored.
    extent: vec2f,
    /// Unit vector to the eye.
    to_eye: vec3f,
    /// log2 of the texels of the height map that the pixel covers.
    level: f32,
}

/// The place of a pixel, whose neighbours differ by so many metres.
fn host_place(vertex: HostVertex, ddx: vec3f, ddy: vec3f) -> HostPlace {
    let position = Place(vertex.origin, vertex.local, ddx, ddy);
    let size = vec2f(textureDimensions(host_height));
    let extent = size * host_view.spacing * vertex.mirror;
    let across = (position.local.xz - vertex.rest) / host_view.spacing * vertex.mirror;
    let terrain_uv = Coord((vec2f(vertex.texel) + across + 0.5) / size, ddx.xz / extent, ddy.xz / extent);

    let footprint = max(length(ddx.xz / host_view.spacing), length(ddy.xz / host_view.spacing));
    let finest = f32(textureNumLevels(host_height) - 1u);
    let level = clamp(log2(max(footprint, 1e-6)), 0.0, finest);
    let shape = host_shape_mirrored(host_shape_filtered(vertex.texel, across, level), vertex.mirror);
    let normal = host_normal(shape);

    let flat = vec2f(vertex.unfolded - host_view.eye_texel) * host_view.spacing - host_view.eye_offset
        + position.local.xz - vertex.rest;
    let to_eye = -vec3f(flat.x, position.local.y - host_view.eye_height, flat.y);
    let distance = length(to_eye);
    let frame = HostFrame(
        position,
        terrain_uv,
        position.local.y,
        1.0 - normal.y,
        normal,
        host_curvature(shape),
        distance,
        host_view.sun,
    );
    return HostPlace(frame, extent, to_eye / distance, level);
}

/// Light that comes from a place to the eye. `sun` and `open` are the shares of the sun and of the sky that its own relief
/// leaves.
fn host_ground(vertex: HostVertex, place: HostPlace, material: TerrainOut, sun_share: f32, open: f32) -> vec4f {
    let frame = place.frame;
    let itself = all(vertex.unfolded == vertex.texel) && all(vertex.mirror > vec2f(0.0));
    let horizon = host_horizon_at(frame.terrain_uv.uv, place.level, vertex.mirror, itself);
    let sky = textureSampleLevel(host_light, host_sampler, frame.terrain_uv.uv, 0i, 0.0);
    let visible = vec3f(sky.x * vertex.mirror.x, sky.y, sky.z * vertex.mirror.y);
    let height = saturate((frame.height - host_view.low) / host_view.height_range);
    let sun = mix(host_view.sun_low, host_view.sun_high, height) * (host_sun_visible(horizon) * sun_share);
    var occluded = material;
    occluded.occlusion *= open;
    // Ground is lit by ground of its own kind.
    let light = host_beside(HostLight(sun, visible, sky.w, material.albedo), -place.to_eye * frame.distance);
    let radiance = host_shade(occluded, frame.normal, place.to_eye, light);
    return vec4f(host_through_air(radiance, vertex.clip.xy / host_view.pixels, frame.height, frame.distance), 1.0);
}
