//! A material with relief on the preview's square and ball: under the ball's surface as under the plane that touches it there.

fn preview_seen(frame: HostFrame, to_eye: vec3f, pixel: vec2f) -> PreviewSeen {
    let traced = host_traced(frame, to_eye, vec2f(2.0 * host_view.spacing.x));
    let material = terrane_shade(traced.frame);
    let sun = host_relief_sun(traced, normal_to_world(material.normal, frame.normal));
    return PreviewSeen(material, sun, host_relief_sky(traced, material.normal, pixel));
}
