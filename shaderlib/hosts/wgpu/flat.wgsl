//! Entry point for terrain whose ground is what the height map says.

@fragment
fn terrain_fragment(vertex: HostVertex) -> @location(0) vec4f {
    let place = host_place(vertex, dpdx(vertex.local), dpdy(vertex.local));
    return host_ground(vertex, place, terrane_shade(place.frame), 1.0, 1.0);
}
