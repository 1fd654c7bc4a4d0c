//! Entry point for terrain whose materials have relief.

struct HostDisplaced {
    @location(0) radiance: vec4f,
    /// Depth of what was met: 1 near, 0 at infinity.
    @location(1) depth: f32,
}

@fragment
fn terrain_fragment(vertex: HostVertex) -> HostDisplaced {
    let first = host_place(vertex, dpdx(vertex.local), dpdy(vertex.local));
    let traced = host_traced(first.frame, first.to_eye, first.extent);
    let material = terrane_shade(traced.frame);
    let sun = host_relief_sun(traced, normal_to_world(material.normal, first.frame.normal));
    let open = host_relief_sky(traced, material.normal, vertex.clip.xy);
    var place = first;
    place.frame = traced.frame;
    let radiance = host_ground(vertex, place, material, sun, open);
    let clip = host_view.clip * vec4f(traced.moved - first.to_eye * first.frame.distance, 1.0);
    return HostDisplaced(radiance, clip.z / clip.w);
}
