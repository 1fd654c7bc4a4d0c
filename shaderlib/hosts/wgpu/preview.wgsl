//! Entry points for one material alone: a square of ground and a ball, on grey ground.
//!
//! Everything is met by rays. Lengths are in units of `host_view.spacing`, so that the picture can show coarse and fine
//! materials; a material still sees metres.

const PREVIEW_PLATE_CENTRE = vec2f(-1.12, 0.0);
/// Half the side of the square.
const PREVIEW_PLATE = 1.0;
const PREVIEW_BALL_CENTRE = vec3f(1.12, 0.9, 0.0);
const PREVIEW_BALL = 0.9;
const PREVIEW_GREY = vec3f(0.22);

/// What a ray meets: distance, and the normal there.
struct PreviewHit { distance: f32, normal: vec3f, ball: bool }

/// A material as it is seen, and the shares of the sun and of the sky that its own relief leaves.
struct PreviewSeen { material: TerrainOut, sun: f32, open: f32 }

@vertex
fn preview_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(select(-1.0, 3.0, index == 1u), select(-1.0, 3.0, index == 2u), 0.0, 1.0);
}

/// Direction through a place of the picture, in samples from its left upper corner.
fn preview_ray(place: vec2f) -> vec3f {
    let at = place / host_view.pixels * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    return normalize(host_view.forward + host_view.right * at.x + host_view.up * at.y);
}

/// Half the chord of the ball over a ray's nearest point to its centre, squared; negative where the ray misses.
fn preview_chord(from_centre: vec3f, ray: vec3f) -> f32 {
    let nearest = from_centre - ray * dot(from_centre, ray);
    return PREVIEW_BALL * PREVIEW_BALL - dot(nearest, nearest);
}

fn preview_hit(eye: vec3f, ray: vec3f) -> PreviewHit {
    let from_centre = eye - PREVIEW_BALL_CENTRE;
    let chord = preview_chord(from_centre, ray);
    if chord > 0.0 {
        let distance = -dot(from_centre, ray) - sqrt(chord);
        return PreviewHit(distance, (from_centre + ray * distance) / PREVIEW_BALL, true);
    }
    // The camera looks down: every other ray meets the ground.
    return PreviewHit(eye.y / max(-ray.y, 1e-4), vec3f(0.0, 1.0, 0.0), false);
}

/// Where the ray through a neighbouring sample meets the surface's tangent plane, from where this one does.
fn preview_step(eye: vec3f, at: vec3f, normal: vec3f, place: vec2f) -> vec3f {
    let ray = preview_ray(place);
    let facing = dot(ray, normal);
    // At the ball's edge a pixel covers more than the ball: a finite step will do.
    return eye + ray * (dot(at - eye, normal) / min(facing, -0.02)) - at;
}

/// The light on open ground beside the ball, or on the ball over open ground.
fn preview_light(at: vec3f, hit: PreviewHit) -> HostLight {
    let sun = host_view.sun_low;
    if hit.ball {
        // Half of the sum of both hemispheres' axes is the vector of what they share.
        return HostLight(sun, (hit.normal + vec3f(0.0, 1.0, 0.0)) * 0.5, host_view.sun.y, PREVIEW_GREY);
    }
    let to_ball = PREVIEW_BALL_CENTRE - at;
    let away = length(to_ball);
    // Part of the cosine-weighted sky behind a ball that lies over the horizontal.
    let hidden = to_ball.y * PREVIEW_BALL * PREVIEW_BALL / (away * away * away);
    let chord = preview_chord(-to_ball, host_view.sun);
    let miss = sqrt(PREVIEW_BALL * PREVIEW_BALL - chord) - PREVIEW_BALL;
    // The sun's radius seen from here, at the ball.
    let lit = saturate(0.5 + 0.5 * miss / (host_view.sun_radius * away));
    let behind = dot(to_ball, host_view.sun) > 0.0;
    // What hides the sky is the ball's lower half, which sees no sun and little of the ground.
    let around = host_view.sun.y * (1.0 - hidden) * 0.3;
    return HostLight(sun * select(1.0, lit, behind), vec3f(0.0, 1.0 - hidden, 0.0), around, PREVIEW_GREY);
}

/// What a place tells its material, in metres from the middle of the square or of the ball.
fn preview_frame(place: vec2f, eye: vec3f, at: vec3f, hit: PreviewHit) -> HostFrame {
    let metres = host_view.spacing.x;
    let centre = select(vec3f(PREVIEW_PLATE_CENTRE.x, 0.0, PREVIEW_PLATE_CENTRE.y), PREVIEW_BALL_CENTRE, hit.ball);
    let ddx = preview_step(eye, at, hit.normal, place + vec2f(1.0, 0.0));
    let ddy = preview_step(eye, at, hit.normal, place + vec2f(0.0, 1.0));
    let position = Place(vec2i(0i), (at - centre) * metres, ddx * metres, ddy * metres);
    let uv = Coord((at - centre).xz * 0.5 + 0.5, ddx.xz * 0.5, ddy.xz * 0.5);
    return HostFrame(
        position,
        uv,
        at.y * metres,
        1.0 - hit.normal.y,
        hit.normal,
        select(0.0, 1.0 / (PREVIEW_BALL * metres), hit.ball),
        hit.distance * metres,
        host_view.sun,
    );
}

@fragment
fn preview_fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let middle = (vec2f(host_view.eye_texel) + 0.5) * host_view.spacing + host_view.eye_offset;
    let eye = vec3f(middle.x, host_view.eye_height, middle.y) / host_view.spacing.x - vec3f(1.0, 0.0, 1.0);
    let ray = preview_ray(position.xy);
    let hit = preview_hit(eye, ray);
    let at = eye + ray * hit.distance;
    let bare = TerrainOut(PREVIEW_GREY, vec3f(0.0, 0.0, 1.0), 1.0, 0.0, 1.0, vec3f(0.0));
    var seen = PreviewSeen(bare, 1.0, 1.0);
    let beside = abs(at.xz - PREVIEW_PLATE_CENTRE);
    if hit.ball || max(beside.x, beside.y) < PREVIEW_PLATE {
        seen = preview_seen(preview_frame(position.xy, eye, at, hit), -ray, position.xy);
    }
    var light = preview_light(at, hit);
    light.sun *= seen.sun;
    seen.material.occlusion *= seen.open;
    return vec4f(host_shade(seen.material, hit.normal, -ray, light), 1.0);
}
