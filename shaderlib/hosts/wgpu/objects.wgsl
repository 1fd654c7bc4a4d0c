//! Solids that stand on a terrain, and where a ray from the eye meets them. All are convex.

const HOST_SPHERE = 0u;
const HOST_BOX = 1u;
const HOST_COLUMN = 2u;
/// No object.
const HOST_NOTHING = 16u;

struct HostObject {
    /// Metres from the eye to its middle.
    center: vec3f,
    /// One of the shapes above.
    shape: u32,
    /// Half its extent along its own axes, in metres.
    half_size: vec3f,
    roughness: f32,
    albedo: vec3f,
    /// Radius of a sphere around it, in metres.
    around: f32,
    /// Its own axis x, on the world's x and z.
    turn: vec2f,
    /// Its middle's x and z in 1/256 m.
    origin: vec2i,
    /// Metres from there to the middle, below 1/256.
    rest: vec2f,
}

struct HostObjects {
    list: array<HostObject, 16>,
    count: u32,
}

@group(0) @binding(7) var<uniform> host_objects: HostObjects;

/// What a ray meets first: the object, metres along the ray, and the normal there.
struct HostMet { object: u32, distance: f32, normal: vec3f }

/// A vector of the world in an object's own axes.
fn host_own(turn: vec2f, way: vec3f) -> vec3f {
    return vec3f(dot(way.xz, turn), way.y, turn.x * way.z - turn.y * way.x);
}

/// The other way round.
fn host_unown(turn: vec2f, way: vec3f) -> vec3f {
    return vec3f(turn.x * way.x - turn.y * way.z, way.y, dot(way.zx, turn));
}

/// No component so small that a quotient by it would not be finite.
fn host_divisor(way: vec3f) -> vec3f {
    return select(way, vec3f(1e-12), abs(way) < vec3f(1e-12));
}

/// Metres along a ray of length 1 to where it enters a sphere around the origin, negative where it does not.
fn host_enter_sphere(origin: vec3f, way: vec3f, radius: f32) -> f32 {
    let along = dot(origin, way);
    let nearest = origin - way * along;
    let chord = radius * radius - dot(nearest, nearest);
    return select(-1.0, -along - sqrt(max(chord, 0.0)), chord > 0.0);
}

/// The same for each pair of a box's faces: where the ray comes between them, and where it leaves.
fn host_enter_box(origin: vec3f, way: vec3f, half_size: vec3f) -> HostMet {
    let over = 1.0 / host_divisor(way);
    let middle = -origin * over;
    let reach = half_size * abs(over);
    let entries = middle - reach;
    let enter = max(max(entries.x, entries.y), entries.z);
    let exits = middle + reach;
    if enter >= min(min(exits.x, exits.y), exits.z) {
        return HostMet(HOST_NOTHING, -1.0, vec3f(0.0));
    }
    let first = vec3<bool>(
        entries.x == enter,
        entries.y == enter && entries.x < enter,
        max(entries.x, entries.y) < enter,
    );
    return HostMet(0u, enter, select(vec3f(0.0), -sign(way), first));
}

/// The same for an upright cylinder.
fn host_enter_column(origin: vec3f, way: vec3f, half_size: vec3f) -> HostMet {
    let flat = max(dot(way.xz, way.xz), 1e-12);
    let aside = origin.z * way.x - origin.x * way.z;
    let chord = half_size.x * half_size.x - aside * aside / flat;
    let middle = -dot(origin.xz, way.xz) / flat;
    let reach = sqrt(max(chord, 0.0) / flat);
    let over = 1.0 / host_divisor(way).y;
    let level = -origin.y * over - half_size.y * abs(over);
    let enter = max(middle - reach, level);
    let leave = min(middle + reach, -origin.y * over + half_size.y * abs(over));
    if chord <= 0.0 || enter >= leave {
        return HostMet(HOST_NOTHING, -1.0, vec3f(0.0));
    }
    let at = origin + way * enter;
    let side = vec3f(at.x, 0.0, at.z) / half_size.x;
    return HostMet(0u, enter, select(side, vec3f(0.0, -sign(way.y), 0.0), level > middle - reach));
}

/// Where a ray of length 1 from the eye meets an object, at a negative distance where it does not.
fn host_object_met(object: u32, way: vec3f) -> HostMet {
    let solid = host_objects.list[object];
    let origin = host_own(solid.turn, -solid.center);
    let own = host_own(solid.turn, way);
    if solid.shape == HOST_SPHERE {
        let distance = host_enter_sphere(origin, own, solid.half_size.x);
        return HostMet(object, distance, (way * distance - solid.center) / solid.half_size.x);
    }
    var met: HostMet;
    if solid.shape == HOST_BOX {
        met = host_enter_box(origin, own, solid.half_size);
    } else {
        met = host_enter_column(origin, own, solid.half_size);
    }
    return HostMet(object, met.distance, host_unown(solid.turn, met.normal));
}

/// The object that a ray from the eye meets first.
fn host_first_met(way: vec3f) -> HostMet {
    var first = HostMet(HOST_NOTHING, 3e38, vec3f(0.0));
    for (var object = 0u; object < host_objects.count; object++) {
        let met = host_object_met(object, way);
        if met.distance > 0.0 && met.distance < first.distance {
            first = met;
        }
    }
    return first;
}
