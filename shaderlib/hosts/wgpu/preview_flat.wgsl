//! A material on the preview's square and ball as they are.

fn preview_seen(frame: HostFrame, to_eye: vec3f, pixel: vec2f) -> PreviewSeen {
    return PreviewSeen(terrane_shade(frame), 1.0, 1.0);
}
