//! Entry points for the solids on a terrain: one triangle over the picture, with the depth of what every ray meets first.

/// Albedo of the ground around an object, which its shader does not ask.
const HOST_FLOOR = vec3f(0.2);

/// Tangent of the angle over which a side sees ground in the sun and in shadow as one.
const HOST_AROUND = 0.8;

struct HostObjectSeen {
    @location(0) radiance: vec4f,
    @builtin(frag_depth) depth: f32,
}

@vertex
fn objects_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(select(-1.0, 3.0, index == 1u), select(-1.0, 3.0, index == 2u), 0.0, 1.0);
}

/// Share of the sun that all objects leave to the ground before an object's side: as far before it as the place is high.
fn host_before(met: HostMet, at: vec3f, under: HostUnder) -> f32 {
    let over = max(at.y + host_view.eye_height - host_ground_height(under), 0.0);
    let out = met.normal.xz * inverseSqrt(max(dot(met.normal.xz, met.normal.xz), 1e-12)) * over;
    let ground = at + vec3f(out.x, -over, out.y);
    var sun = 1.0;
    for (var object = 0u; object < host_objects.count; object++) {
        sun *= host_object_sun(object, ground, HOST_AROUND);
    }
    return sun;
}

/// The light on an object, `at` metres from the eye, but for what relief takes of it.
fn host_object_light(met: HostMet, at: vec3f) -> HostLight {
    let under = host_under(at);
    let uv = under.uv;
    let horizon = host_horizon_at(uv, 0.0, vec2f(1.0), true);
    let sky = textureSampleLevel(host_light, host_sampler, uv, 0i, 0.0);
    let height = saturate((at.y + host_view.eye_height - host_view.low) / host_view.height_range);
    let sun = mix(host_view.sun_low, host_view.sun_high, height) * host_sun_visible(horizon);
    // Half of the sum of both hemispheres' axes is the vector of what they share.
    let visible = (met.normal * length(sky.xyz) + sky.xyz) * 0.5;
    let around = sky.w * host_before(met, at, under);
    return host_among(HostLight(sun, visible, around, HOST_FLOOR), at, met.object);
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
    let left = host_object_sunk(met, at, position.xy);
    let material = TerrainOut(solid.albedo, vec3f(0.0, 0.0, 1.0), solid.roughness, 0.0, left.open, vec3f(0.0));
    var light = host_object_light(met, at);
    light.sun *= left.sun;
    let radiance = host_shade(material, met.normal, -way, light);
    let seen = host_through_air(radiance, picture, at.y + host_view.eye_height, met.distance);
    return HostObjectSeen(vec4f(seen, 1.0), clip.z / clip.w);
}
