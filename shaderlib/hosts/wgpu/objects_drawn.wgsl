//! Entry points for the solids on a terrain: one triangle over the picture, with the depth of what every ray meets first.

/// Albedo of the ground under an object, of which its shader knows nothing.
const HOST_FLOOR = vec3f(0.2);

struct HostObjectSeen {
    @location(0) radiance: vec4f,
    @builtin(frag_depth) depth: f32,
}

@vertex
fn objects_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(select(-1.0, 3.0, index == 1u), select(-1.0, 3.0, index == 2u), 0.0, 1.0);
}

/// The light on an object, `at` metres from the eye.
fn host_object_light(met: HostMet, at: vec3f) -> HostLight {
    let size = vec2f(textureDimensions(host_height));
    let texel = vec2f(host_view.eye_texel) + (host_view.eye_offset + at.xz) / host_view.spacing;
    let uv = (texel + 0.5) / size;
    let horizon = host_horizon_at(uv, 0.0, vec2f(1.0), true);
    let sky = textureSampleLevel(host_light, host_sampler, uv, 0i, 0.0);
    let height = saturate((at.y + host_view.eye_height - host_view.low) / host_view.height_range);
    let sun = mix(host_view.sun_low, host_view.sun_high, height) * host_sun_visible(horizon);
    // Half of the sum of both hemispheres' axes is the vector of what they share.
    let visible = (met.normal * length(sky.xyz) + sky.xyz) * 0.5;
    return host_among(HostLight(sun, visible, sky.w, HOST_FLOOR), at, met.object);
}

@fragment
fn objects_fragment(@builtin(position) position: vec4f) -> HostObjectSeen {
    let picture = position.xy / host_view.pixels;
    let across = picture * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    let way = normalize(host_view.forward + host_view.right * across.x + host_view.up * across.y);
    let met = host_first_met(way);
    let at = way * min(met.distance, 1e9);
    let clip = host_view.clip * vec4f(at, 1.0);
    if met.object == HOST_NOTHING || clip.z > clip.w {
        discard;
    }
    let solid = host_objects.list[min(met.object, HOST_NOTHING - 1u)];
    let material = TerrainOut(solid.albedo, vec3f(0.0, 0.0, 1.0), solid.roughness, 0.0, 1.0, vec3f(0.0));
    let radiance = host_shade(material, met.normal, -way, host_object_light(met, at));
    let seen = host_through_air(radiance, picture, at.y + host_view.eye_height, met.distance);
    return HostObjectSeen(vec4f(seen, 1.0), clip.z / clip.w);
}
