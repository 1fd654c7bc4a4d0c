//! Sun, sky and neighbouring ground on a material.

const HOST_PI = 3.14159265;

/// Irradiance of the upper sky on a surface.
fn host_sky_irradiance(n: vec3f) -> vec3f {
    let sky = &host_view.sky;
    let sum = (*sky)[0].rgb * 0.282095
        + ((*sky)[1].rgb * n.y + (*sky)[2].rgb * n.z + (*sky)[3].rgb * n.x) * 0.488603
        + ((*sky)[4].rgb * (n.x * n.y) + (*sky)[5].rgb * (n.y * n.z) + (*sky)[7].rgb * (n.x * n.z)) * 1.092548
        + (*sky)[6].rgb * (0.315392 * (3.0 * n.z * n.z - 1.0))
        + (*sky)[8].rgb * (0.546274 * (n.x * n.x - n.y * n.y));
    return max(sum, vec3f(0.0));
}

/// Irradiance of the visible sky. `visible` is (1/π) ∫ ω dω over it; the sky's colour is taken around its middle.
fn host_visible_sky(normal: vec3f, visible: vec3f) -> vec3f {
    let middle = normalize(visible + vec3f(0.0, 1e-4, 0.0));
    // An even sky would give a surface with the middle as its normal this share of π.
    let even = 0.5 + 0.5 * middle.y;
    return host_sky_irradiance(middle) * (clamp(dot(normal, visible), 0.0, 1.0) / even);
}

/// Rough diffuse reflection over Lambert's. Source: Oren and Nayar, "Generalization of Lambert's Reflectance Model",
/// SIGGRAPH 1994, in the form of Fujii, "A tiny improvement of Oren-Nayar reflectance model", 2012.
fn host_rough_diffuse(n_l: f32, n_v: f32, l_v: f32, roughness: f32) -> f32 {
    let s = l_v - n_l * n_v;
    let t = select(1.0, max(max(n_l, n_v), 1e-3), s > 0.0);
    let a = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * HOST_PI)) * roughness);
    return a + a * roughness * s / t;
}

/// Share of an even environment that is mirrored. Source: Karis, "Physically Based Shading on Mobile", 2014, a fit to
/// Lazarov's.
fn host_environment_share(f0: vec3f, roughness: f32, n_v: f32) -> vec3f {
    let r = roughness * vec4f(-1.0, -0.0275, -0.572, 0.022) + vec4f(1.0, 0.0425, 1.04, -0.04);
    let a = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
    let scale = vec2f(-1.04, 1.04) * a + r.zw;
    return f0 * scale.x + scale.y;
}

/// Light of the surroundings along a reflected ray: mirrored for smooth surfaces, even for rough ones.
fn host_reflected(direction: vec3f, roughness: f32, land: vec3f) -> vec3f {
    let sharp = host_sky_radiance(direction);
    let soft = host_sky_irradiance(direction) / HOST_PI;
    let sky = mix(sharp, soft, smoothstep(0.1, 0.6, roughness));
    let width = 0.05 + 0.6 * roughness;
    return mix(land, sky, smoothstep(-width, width, direction.y));
}

/// Share of a disc on one side of a line: the line's distance from its middle over its radius, negative where less than half
/// is left.
fn host_disc_share(distance: f32) -> f32 {
    let x = clamp(distance, -1.0, 1.0);
    return 0.5 + (x * sqrt(1.0 - x * x) + asin(x)) * 0.318309886;
}

/// Share of the sun's disc above a horizon whose tangent is given.
fn host_sun_visible(horizon: f32) -> f32 {
    let flat = length(host_view.sun.xz);
    // Tangent of the angle between the horizon and the sun's middle.
    let above = (host_view.sun.y - horizon * flat) / max(flat + horizon * host_view.sun.y, 1e-6);
    return host_disc_share(above / host_view.sun_radius);
}

/// The light that reaches a place.
struct HostLight {
    /// Irradiance on a surface that faces the sun, in its shadow or not.
    sun: vec3f,
    /// (1/π) ∫ ω dω over the visible sky.
    visible: vec3f,
    /// Share of the sun's irradiance on the ground around.
    around: f32,
    /// Albedo of that ground.
    land: vec3f,
}

/// Radiance of a material towards the eye. `view` points to the eye.
fn host_shade(material: TerrainOut, ground: vec3f, view: vec3f, light: HostLight) -> vec3f {
    let normal = normal_to_world(material.normal, ground);
    let n_v = clamp(dot(normal, view), 1e-3, 1.0);
    let n_l = dot(normal, host_view.sun);
    let roughness = saturate(material.roughness);
    let f0 = mix(vec3f(0.04), material.albedo, material.metallic);
    let diffuse = material.albedo * (1.0 - material.metallic);

    var radiance = material.emissive;
    if n_l > 0.0 && light.sun.g > 0.0 {
        let half_way = normalize(view + host_view.sun);
        let n_h = clamp(dot(normal, half_way), 0.0, 1.0);
        let v_h = clamp(dot(view, half_way), 0.0, 1.0);
        let rough = host_rough_diffuse(n_l, n_v, dot(view, host_view.sun), roughness);
        let mirrored = fresnel_schlick(f0, v_h) * (ggx(n_h, roughness) * smith_visibility(n_l, n_v, roughness));
        // A bump that faces the sun on ground that does not is in the ground's own shadow.
        let grazing = smoothstep(0.0, 0.1, dot(ground, host_view.sun));
        radiance += (diffuse * (rough / HOST_PI) + mirrored) * light.sun * (n_l * grazing);
    }

    let open = clamp(dot(normal, light.visible), 0.0, 1.0);
    let sky = host_visible_sky(normal, light.visible);
    // What is not sky is ground under the light of the neighbourhood.
    let around = host_view.sun_low * light.around + host_sky_irradiance(vec3f(0.0, 1.0, 0.0)) * light.visible.y;
    let bounce = light.land * around * (1.0 - open);
    radiance += diffuse * (sky + bounce) * (material.occlusion / HOST_PI);

    let mirror = reflect(-view, normal);
    let share = host_environment_share(f0, roughness, n_v);
    // Lagarde and de Rousiers, "Moving Frostbite to PBR", 2014, listing 26: occlusion matters less for mirrors.
    let hidden = clamp(pow(n_v + material.occlusion, exp2(-16.0 * roughness - 1.0)) - 1.0 + material.occlusion, 0.0, 1.0);
    let land = light.land * around / HOST_PI;
    let seen = mix(land, host_reflected(mirror, roughness, land), open);
    return radiance + share * seen * hidden;
}
