//! What the relief around a place leaves of the sun and of the sky. Not a node.
//!
//! What meets a ray is on one mip or between two, and so is what lies in its light: with the finer mip alone, a surface that is
//! nearly the coarser one would lie in the shadow of bumps that it does not have, until the next level lights it at once.
//! Source: Terrane; shadow rays on the displaced surface after Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro 1, 2010, section 1.5.

/// A ray over a layer's map from a point on or over the displaced ground, and what its slope means.
struct DisplacedLightRay {
    /// From over the ground to the light.
    ray: ReliefRay,
    /// The mip that it is traced on.
    field: ReliefField,
    /// The heights of the cell that it starts in.
    own: vec4f,
    /// Steps of height that are as high as a texel of the ray's way is long.
    steps: f32,
}

/// Steps by which a ray starts over the ground, which is in its own shadow.
const DISPLACED_LIGHT_LIFT: f32 = 2.0;

/// By how much the tangent of a horizon of the sky may be too small: 3.6 degrees. What that adds to the error is a
/// tenth of what four directions leave, for two fifths of the time (docs/relief/notebook.md).
const DISPLACED_LIGHT_TOLERANCE: f32 = 0.0625;

/// From a point towards a light over a mip, in the frame of the place; the light stands over the ground.
fn displaced_light_ray(
    layer: DisplacedLayer,
    point: vec3f,
    light: vec3f,
    mip: i32,
    heights: texture_2d_array<u32>,
) -> DisplacedLightRay {
    let field = displaced_field(layer, mip);
    let steps = DISPLACED_STEPS / layer.depth;
    let side = f32(1i << u32(mip));
    let start = displaced_cell(layer, point.xy, mip);
    let texels = (light.x * layer.along_x + light.y * layer.along_y) / side;
    // A light in the zenith still has a way over the ground.
    let fastest = max(max(abs(texels.x), abs(texels.y)), 1e-4);
    let way = select(texels, vec2f(fastest, texels.y), all(abs(texels) < vec2f(fastest))) / fastest;
    let own = relief_corners(heights, field, start.cell, vec2i(0));
    let ground = relief_height(own, start.place);
    let height = max(DISPLACED_STEPS + (point.z + layer.sink) * steps, ground + DISPLACED_LIGHT_LIFT);
    let rise = max(light.z, 1e-4) * steps / fastest;
    let end = min(max(DISPLACED_STEPS + 1.0 - height, 0.0) / rise, DISPLACED_LONGEST);
    let ray = ReliefRay(start.cell, vec3f(start.place, height), vec3f(way, rise), end);
    let metres = length(light.xy) / fastest;
    return DisplacedLightRay(ray, field, own, max(metres, 1e-6) * steps / length(way));
}

/// 1 where the middle of the sun is seen, else 0; between two mips, between what they say.
fn displaced_light_hard(
    layer: DisplacedLayer,
    ray: DisplacedRay,
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
) -> f32 {
    var seen = 0.0;
    for (var coarser = 0i; coarser < displaced_mips(layer); coarser++) {
        let mip = i32(layer.level) + coarser;
        seen += displaced_part(layer, coarser) * displaced_light_hard_on(layer, ray, mip, heights, bounds);
    }
    return seen;
}

/// The same on one mip.
fn displaced_light_hard_on(
    layer: DisplacedLayer,
    ray: DisplacedRay,
    mip: i32,
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
) -> f32 {
    let sight = displaced_light_ray(layer, ray.origin, ray.direction, mip, heights);
    let hit = shadow_hard_trace(heights, bounds, sight.field, sight.ray, sight.own);
    return select(1.0, 0.0, hit.state == RELIEF_HIT);
}

/// The share of the sun's disc that is seen; `radius` is the tangent of its angular radius, and the disc is cut by `planes`, 1 or more.
fn displaced_light_disc(
    layer: DisplacedLayer,
    ray: DisplacedRay,
    radius: f32,
    planes: u32,
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
) -> f32 {
    var seen = 0.0;
    for (var coarser = 0i; coarser < displaced_mips(layer); coarser++) {
        let mip = i32(layer.level) + coarser;
        seen += displaced_part(layer, coarser) * displaced_light_disc_on(layer, ray, radius, planes, mip, heights, bounds);
    }
    return seen;
}

/// The same on one mip.
fn displaced_light_disc_on(
    layer: DisplacedLayer,
    ray: DisplacedRay,
    radius: f32,
    planes: u32,
    mip: i32,
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
) -> f32 {
    let sight = displaced_light_ray(layer, ray.origin, ray.direction, mip, heights);
    let sent = ReliefRay(sight.ray.cell, sight.ray.origin, sight.ray.direction, DISPLACED_LONGEST);
    let seen = shadow_cone_share(
        heights, bounds, sight.field, sent, sight.own, sight.steps, radius, DISPLACED_STEPS, planes, 1.0,
    );
    return seen.share;
}

/// The share of an even sky's light that reaches a surface with this normal, by so many directions, turned by an angle.
///
/// Texels are taken as squares, as wide as the map's mean.
fn displaced_light_sky(
    layer: DisplacedLayer,
    point: vec3f,
    normal: vec3f,
    turn: f32,
    directions: u32,
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
) -> f32 {
    var seen = 0.0;
    for (var coarser = 0i; coarser < displaced_mips(layer); coarser++) {
        let mip = i32(layer.level) + coarser;
        seen += displaced_part(layer, coarser) * displaced_light_sky_on(layer, point, normal, turn, directions, mip, heights, bounds);
    }
    return seen;
}

/// The same on one mip.
fn displaced_light_sky_on(
    layer: DisplacedLayer,
    point: vec3f,
    normal: vec3f,
    turn: f32,
    directions: u32,
    mip: i32,
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
) -> f32 {
    let sight = displaced_light_ray(layer, point, vec3f(1.0, 0.0, 1.0), mip, heights);
    let side = f32(1i << u32(sight.field.mip));
    let area = abs(layer.along_x.x * layer.along_y.y - layer.along_x.y * layer.along_y.x);
    let texel = side * inverseSqrt(max(area, 1e-12));
    let steps = texel * DISPLACED_STEPS / layer.depth;
    // No farther than ten depths: what stands there is low.
    let reach = min(10.0 * layer.depth / texel, 256.0);
    let sent = ReliefRay(sight.ray.cell, sight.ray.origin, vec3f(1.0, 0.0, 0.0), reach);
    let turned = displaced_light_turned(layer, normal);
    let seen = occlusion_directions_search(
        heights, bounds, sight.field, sent, sight.own, turned, steps, turn, DISPLACED_STEPS, directions,
        DISPLACED_LIGHT_TOLERANCE,
    );
    return seen.share;
}

/// A vector of the place's frame in that of the map.
fn displaced_light_turned(layer: DisplacedLayer, way: vec3f) -> vec3f {
    let size = sqrt(max(abs(layer.along_x.x * layer.along_y.y - layer.along_x.y * layer.along_y.x), 1e-12));
    return normalize(vec3f((way.x * layer.along_x + way.y * layer.along_y) / size, way.z));
}
