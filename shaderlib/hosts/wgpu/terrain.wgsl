//! Entry points for terrain: a grid of 33 × 33 vertices per patch, lifted by the height map.

struct HostPatch {
    /// Texel of the north-west corner.
    @location(1) texel: vec2i,
    /// That corner's x and z in 1/256 m.
    @location(2) origin: vec2i,
    /// Metres from there to the corner, below 1/256.
    @location(3) rest: vec2f,
    /// Texels between vertices.
    @location(4) step: i32,
}

struct HostVertex {
    // The pre-pass must land on the same depth, bit for bit.
    @builtin(position) @invariant clip: vec4f,
    /// Metres from the patch's origin; y is the height.
    @location(0) local: vec3f,
    @location(1) @interpolate(flat) texel: vec2i,
    @location(2) @interpolate(flat) origin: vec2i,
    @location(3) @interpolate(flat) rest: vec2f,
}

@vertex
fn terrain_vertex(@location(0) corner: vec2u, patch_: HostPatch) -> HostVertex {
    let last = vec2i(textureDimensions(host_height)) - 1i;
    // The terrain ends inside a patch: what lies beyond shrinks to its border.
    let texel = min(patch_.texel + vec2i(corner) * patch_.step, last);
    let height = textureLoad(host_height, texel, 0i).r;
    let local = patch_.rest + vec2f(texel - patch_.texel) * host_view.spacing;
    // From whole texels, so that patches that share a vertex agree on it to the last bit.
    let flat = vec2f(texel - host_view.eye_texel) * host_view.spacing - host_view.eye_offset;
    var vertex: HostVertex;
    vertex.clip = host_view.clip * vec4f(flat.x, height - host_view.eye_height, flat.y, 1.0);
    vertex.local = vec3f(local.x, height, local.y);
    vertex.texel = patch_.texel;
    vertex.origin = patch_.origin;
    vertex.rest = patch_.rest;
    return vertex;
}

@fragment
fn terrain_fragment(vertex: HostVertex) -> @location(0) vec4f {
    let position = Place(vertex.origin, vertex.local, dpdx(vertex.local), dpdy(vertex.local));
    let size = vec2f(textureDimensions(host_height));
    let extent = size * host_view.spacing;
    let across = (position.local.xz - vertex.rest) / host_view.spacing;
    let terrain_uv = Coord(
        (vec2f(vertex.texel) + across + 0.5) / size,
        position.ddx.xz / extent,
        position.ddy.xz / extent,
    );

    let footprint = max(length(position.ddx.xz / host_view.spacing), length(position.ddy.xz / host_view.spacing));
    let finest = f32(textureNumLevels(host_height) - 1u);
    let level = clamp(log2(max(footprint, 1e-6)), 0.0, finest);
    let shape = host_shape_filtered(vertex.texel, across, level);
    let normal = host_normal(shape);

    let flat = vec2f(vertex.texel - host_view.eye_texel) * host_view.spacing - host_view.eye_offset
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
    let material = terrane_shade(frame);

    let horizon = textureSampleLevel(host_horizon, host_sampler, terrain_uv.uv, level).r;
    let sky = textureSampleLevel(host_light, host_sampler, terrain_uv.uv, 0.0);
    let height = saturate((position.local.y - host_view.low) / host_view.height_range);
    let sun = mix(host_view.sun_low, host_view.sun_high, height) * host_sun_visible(horizon);
    // Ground is lit by ground of its own kind.
    let light = HostLight(sun, sky.xyz, sky.w, material.albedo);
    let radiance = host_shade(material, normal, to_eye / distance, light);
    return vec4f(host_through_air(radiance, vertex.clip.xy / host_view.pixels, position.local.y, distance), 1.0);
}
