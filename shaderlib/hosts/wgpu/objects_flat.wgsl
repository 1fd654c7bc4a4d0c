//! Solids on ground without relief.

fn host_object_sunk(met: HostMet, at: vec3f, pixel: vec2f) -> HostSunk {
    return HostSunk(1.0, 1.0);
}
