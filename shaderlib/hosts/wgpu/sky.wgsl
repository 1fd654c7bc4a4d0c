//! Entry points for the sky: one triangle over the picture, at the depth of infinity.

struct HostSkyVertex {
    @builtin(position) clip: vec4f,
    @location(0) direction: vec3f,
}

@vertex
fn sky_vertex(@builtin(vertex_index) index: u32) -> HostSkyVertex {
    let x = select(-1.0, 3.0, index == 1u);
    let y = select(-1.0, 3.0, index == 2u);
    return HostSkyVertex(vec4f(x, y, 0.0, 1.0), host_view.forward + host_view.right * x + host_view.up * y);
}

@fragment
fn sky_fragment(vertex: HostSkyVertex) -> @location(0) vec4f {
    let direction = normalize(vertex.direction);
    var radiance = host_sky_radiance(direction);
    // The disc's edge is darker. Source: Hestroffer and Magnan, "Wavelength dependency of the Solar limb darkening",
    // Astronomy & Astrophysics 333, 1998: exponents at 680, 550 and 440 nm.
    let off = length(cross(direction, host_view.sun)) / host_view.sun_radius;
    if off < 1.0 && dot(direction, host_view.sun) > 0.0 {
        radiance += host_view.sun_disc * pow(vec3f(sqrt(1.0 - off * off)), vec3f(0.397, 0.503, 0.652));
    }
    return vec4f(min(radiance, vec3f(60000.0)), 1.0);
}
