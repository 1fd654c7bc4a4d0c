//! Solids in relief: what of them is lower than the height map's ground lies in the shadow of stones and in cracks.

/// The height map's ground over a place that lies `at` metres from the eye.
fn host_object_frame(met: HostMet, at: vec3f, ground: f32, under: HostUnder) -> HostFrame {
    let solid = host_objects.list[met.object];
    let from_middle = at.xz - solid.center.xz + solid.rest;
    // A pixel of a plane that faces the eye: enough for the mip of the relief and for masks.
    let pixel = 2.0 * length(host_view.right) / host_view.pixels.x * met.distance;
    let place = Place(
        solid.origin,
        vec3f(from_middle.x, ground, from_middle.y),
        vec3f(pixel, 0.0, 0.0),
        vec3f(0.0, 0.0, pixel),
    );
    let extent = vec2f(textureDimensions(host_height)) * host_view.spacing;
    let uv = Coord(under.uv, vec2f(pixel, 0.0) / extent, vec2f(0.0, pixel) / extent);
    let shape = host_shape(under.texel, under.part, 0i);
    let normal = host_normal(shape);
    return HostFrame(
        place,
        uv,
        ground,
        1.0 - normal.y,
        normal,
        host_curvature(shape),
        met.distance,
        host_view.sun,
    );
}

fn host_object_sunk(met: HostMet, at: vec3f, pixel: vec2f) -> HostSunk {
    let under = host_under(at);
    let ground = host_ground_height(under);
    let over = at.y + host_view.eye_height - ground;
    if over >= 0.0 {
        return HostSunk(1.0, 1.0);
    }
    let frame = host_object_frame(met, at, ground, under);
    let tangent = normal_to_world(vec3f(1.0, 0.0, 0.0), frame.normal);
    let bitangent = normal_to_world(vec3f(0.0, 1.0, 0.0), frame.normal);
    let relief = terrane_ground(frame, tangent, bitangent, frame.position.ddx.x);
    let down = vec3f(0.0, over, 0.0);
    var traced = HostTraced(frame, relief, DisplacedHit(0.0, 0u, true), vec3f(0.0), down, tangent, bitangent);
    traced.point = host_in_ground(traced, down);
    return HostSunk(host_relief_sun(traced, met.normal), host_relief_sky(traced, vec3f(0.0, 0.0, 1.0), pixel));
}
