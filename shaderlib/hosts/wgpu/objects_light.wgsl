//! The light that solids take from places around them.
//!
//! Sun: how far its middle lies outside a solid's outline, as the sine of an angle, and the part of the disc that a line
//! so far from its middle leaves. Sky: (1/π) ∫ ω dω over what a solid hides of it, which is part of the vector that
//! `HostLight` has.

/// Sine of the angle from the sun's middle out of a sphere's outline. `to`: from the place to the sphere's middle.
fn host_off_sphere(to: vec3f, radius: f32) -> f32 {
    let away = length(to);
    if dot(to, host_view.sun) <= 0.0 {
        return 1.0;
    }
    let inner = min(radius / away, 1.0);
    let outer = length(cross(to, host_view.sun)) / away;
    return outer * sqrt(1.0 - inner * inner) - inner * dot(to, host_view.sun) / away;
}

/// Sine of the angle from `way` out of the plane through a place and an edge. An edge is a point on two axes: where a ray
/// leaves the solid on the first of them (`far`) and enters it on the second (`near`).
fn host_off_edge(far: f32, near: f32, way: vec2f) -> f32 {
    return (near * way.x - far * way.y) / max(length(vec2f(far, near)), 1e-6);
}

/// The same out of a box's outline, whose edges are those where a face that a ray enters meets one that it leaves.
/// `place`: from the box's middle to the place, `way` to the sun, both in the box's axes.
fn host_off_box(place: vec3f, way: vec3f, half_size: vec3f) -> f32 {
    let mirror = select(vec3f(-1.0), vec3f(1.0), way >= vec3f(0.0));
    let far = half_size - place * mirror;
    let near = -half_size - place * mirror;
    if any(far <= vec3f(0.0)) {
        return 1.0;
    }
    let w = way * mirror;
    let x = max(host_off_edge(far.x, near.y, w.xy), host_off_edge(far.x, near.z, w.xz));
    let y = max(host_off_edge(far.y, near.x, w.yx), host_off_edge(far.y, near.z, w.yz));
    return max(max(x, y), max(host_off_edge(far.z, near.x, w.zx), host_off_edge(far.z, near.y, w.zy)));
}

/// The same out of a column's outline: out of its two sides, over its top, under its foot.
fn host_off_column(place: vec3f, way: vec3f, half_size: vec3f) -> f32 {
    let flat = max(length(way.xz), 1e-6);
    let along = way.xz / flat;
    let aside = abs(place.z * along.x - place.x * along.y);
    let before = -dot(place.xz, along);
    let radius = half_size.x;
    let away = length(place.xz);
    let reach = sqrt(max(radius * radius - aside * aside, 0.0));
    if before + reach <= 0.0 {
        return 1.0;
    }
    let inner = min(radius / max(away, 1e-6), 1.0);
    let side = (aside * sqrt(1.0 - inner * inner) - before * inner) / max(away, 1e-6) * flat;
    let rise = way.y / flat;
    let over = (place.y + rise * max(before - reach, 0.0) - half_size.y) / max(before - reach, 1e-4) * flat;
    let under = (-half_size.y - place.y - rise * (before + reach)) / (before + reach) * flat;
    return max(max(over, under), select(side, -1.0, away <= radius));
}

/// Share of a sun with that tangent of its radius that an object leaves to a place that lies `at` metres from the eye.
fn host_object_sun(object: u32, at: vec3f, sun_radius: f32) -> f32 {
    let solid = host_objects.list[object];
    let to = solid.center - at;
    var off = host_off_sphere(to, solid.around);
    let is_near = length(to) < solid.around || off < sun_radius;
    if is_near && solid.shape != HOST_SPHERE {
        let place = host_own(solid.turn, -to);
        let way = host_own(solid.turn, host_view.sun);
        if solid.shape == HOST_BOX {
            off = host_off_box(place, way, solid.half_size);
        } else {
            off = host_off_column(place, way, solid.half_size);
        }
    }
    return host_disc_share(off / sun_radius);
}

/// Share of the upper hemisphere's cosine that a sphere hides, the part below the horizon left out. `up`: cosine of the
/// angle from the zenith to its middle, `far`: metres to there over its radius. Source: Snyder, "Area Light Sources for
/// Real-Time Graphics", Microsoft Research MSR-TR-96-11, 1996, the irradiance of a spherical source that the horizon cuts.
fn host_hidden_sphere(up: f32, far: f32) -> f32 {
    let square = far * far;
    let cut = 1.0 - square * up * up;
    if cut <= 0.0 {
        return max(up, 0.0) / square;
    }
    let edge = sqrt(max(square - 1.0, 1e-8));
    let angle = acos(clamp(-up * edge / sqrt(max(1.0 - up * up, 1e-8)), -1.0, 1.0));
    let whole = (up * angle - sqrt(cut) * edge) / square + atan(sqrt(cut) / edge);
    return max(whole / HOST_PI, 0.0);
}

/// The side of a polygon from `a` to `b`, both seen from the place: its part of 2 ∫ ω dω. Source: Lambert's formula, as
/// in Arvo, "Applications of Irradiance Tensors to the Simulation of Non-Lambertian Phenomena", SIGGRAPH 1995.
fn host_hidden_side(a: vec3f, b: vec3f) -> vec3f {
    let turned = cross(a, b);
    let size = length(turned);
    return turned * (atan2(size, dot(a, b)) / max(size, 1e-12));
}

/// A parallelogram's part of (1/π) ∫ ω dω: from its middle and half its sides.
fn host_hidden_face(middle: vec3f, side: vec3f, other: vec3f) -> vec3f {
    let a = middle - side - other;
    let b = middle + side - other;
    let c = middle + side + other;
    let d = middle - side + other;
    let sum = host_hidden_side(a, b) + host_hidden_side(b, c) + host_hidden_side(c, d) + host_hidden_side(d, a);
    return sum * (select(-0.5, 0.5, dot(sum, middle) > 0.0) / HOST_PI);
}

/// What a box that begins at the horizon or above hides. `to`: from the place to its middle, in its own axes.
fn host_hidden_box(to: vec3f, half_size: vec3f) -> vec3f {
    var hidden = vec3f(0.0);
    let face = to - sign(to) * half_size;
    let x = vec3f(half_size.x, 0.0, 0.0);
    let y = vec3f(0.0, half_size.y, 0.0);
    let z = vec3f(0.0, 0.0, half_size.z);
    if abs(to.x) > half_size.x {
        hidden += host_hidden_face(vec3f(face.x, to.yz), y, z);
    }
    if to.y > half_size.y {
        hidden += host_hidden_face(vec3f(to.x, face.y, to.z), x, z);
    }
    if abs(to.z) > half_size.z {
        hidden += host_hidden_face(vec3f(to.xy, face.z), x, y);
    }
    return hidden;
}

/// The same for a column: the rectangle between the two lines in which planes through the place touch it.
fn host_hidden_column(to: vec3f, half_size: vec3f) -> vec3f {
    let away = length(to.xz);
    let inner = half_size.x / max(away, 1e-6);
    if inner >= 1.0 {
        return vec3f(0.0);
    }
    let along = to.xz / away;
    let before = along * (away * (1.0 - inner * inner));
    let reach = half_size.x * sqrt(1.0 - inner * inner);
    let side = vec3f(-along.y, 0.0, along.x) * reach;
    return host_hidden_face(vec3f(before.x, to.y, before.y), side, vec3f(0.0, half_size.y, 0.0));
}

/// What an object hides of the sky over a place that lies `at` metres from the eye.
fn host_object_hidden(object: u32, at: vec3f) -> vec3f {
    let solid = host_objects.list[object];
    let to = solid.center - at;
    let far = length(to) / solid.around;
    // Farther away it hides less than a step of 8 bits.
    if far > 32.0 || to.y + solid.half_size.y <= 0.0 {
        return vec3f(0.0);
    }
    if solid.shape == HOST_SPHERE {
        let up = to.y / length(to);
        // The horizon leaves about that part of what a sphere hides on either side.
        let over = saturate(0.5 + 0.5 * up * far);
        let flat = to.xz * (over / (max(far * far, 1.0) * length(to)));
        return vec3f(flat.x, host_hidden_sphere(up, max(far, 1.0)), flat.y);
    }
    // The horizon cuts off what lies lower than the place.
    let low = max(to.y - solid.half_size.y, 0.0);
    let high = to.y + solid.half_size.y;
    var own = host_own(solid.turn, to);
    own.y = 0.5 * (low + high);
    let half_size = vec3f(solid.half_size.x, 0.5 * (high - low), solid.half_size.z);
    if solid.shape == HOST_BOX {
        return host_unown(solid.turn, host_hidden_box(own, half_size));
    }
    return host_unown(solid.turn, host_hidden_column(own, half_size));
}

/// The light at a place that lies `at` metres from the eye, on an object or on none.
fn host_among(light: HostLight, at: vec3f, itself: u32) -> HostLight {
    var left = light;
    for (var object = 0u; object < host_objects.count; object++) {
        if object != itself {
            left.sun *= host_object_sun(object, at, host_view.sun_radius);
            left.visible -= host_object_hidden(object, at);
        }
    }
    return left;
}

/// The light on the ground.
fn host_beside(light: HostLight, at: vec3f) -> HostLight {
    return host_among(light, at, HOST_NOTHING);
}
