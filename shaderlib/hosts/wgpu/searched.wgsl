//! Entry point that shows what the search for relief did, instead of what it found.

struct HostSearched {
    /// Nodes and samples that were read, 1 where the search came to its end, log2 of the texels in a metre.
    @location(0) search: vec4f,
    /// Metres from the ground to what was met, along the eye's ray, and one more; 0 where nothing is displaced.
    @location(1) distance: f32,
}

@fragment
fn terrain_fragment(vertex: HostVertex) -> HostSearched {
    let first = host_place(vertex, dpdx(vertex.local), dpdy(vertex.local));
    let traced = host_traced(first.frame, first.to_eye, first.extent);
    if traced.relief.deepest <= 0.0 {
        return HostSearched(vec4f(0.0, 1.0, 0.0, 1.0), 0.0);
    }
    let done = select(0.0, 1.0, traced.hit.done);
    return HostSearched(vec4f(f32(traced.hit.steps), done, terrane_texels(traced.relief), 1.0), 1.0 + traced.hit.distance);
}
