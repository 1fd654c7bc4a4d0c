// The engine's own half of the shader: geometry, light, camera. `engine_material` is written by shader.rs.

struct EngineView {
    clip: mat4x4f,
    /// Metres from the terrain's north-west corner, y up.
    eye: vec3f,
    /// Side of a patch in metres.
    patch_size: f32,
    /// Unit vector to the sun.
    sun: vec3f,
    /// Patches from west to east.
    columns: u32,
    /// Metres on x and z.
    size: vec2f,
    /// The same side of a patch in 1/256 m.
    patch_fixed: i32,
}

/// What this engine knows of a point on the ground: all that a material may ask for.
struct EngineGround {
    corner: vec2i,
    local: vec3f,
    local_dx: vec3f,
    local_dy: vec3f,
    uv: vec2f,
    uv_dx: vec2f,
    uv_dy: vec2f,
    normal: vec3f,
    curvature: f32,
    distance: f32,
    sun: vec3f,
}

struct EngineVertex {
    @builtin(position) clip: vec4f,
    @location(0) local: vec3f,
    @location(1) @interpolate(flat) cell: vec2u,
}

@group(0) @binding(0) var<uniform> engine_view: EngineView;
@group(0) @binding(1) var engine_heights: texture_2d<f32>;

/// Quads on a patch's side.
const ENGINE_QUADS = 16u;

fn engine_texel(texel: vec2i) -> f32 {
    let last = vec2i(textureDimensions(engine_heights)) - 1;
    return textureLoad(engine_heights, clamp(texel, vec2i(0), last), 0).r;
}

/// Metres, bilinear between texel centres.
fn engine_height(xz: vec2f) -> f32 {
    let at = xz / engine_view.size * vec2f(textureDimensions(engine_heights)) - 0.5;
    let texel = vec2i(floor(at));
    let part = fract(at);
    let north = mix(engine_texel(texel), engine_texel(texel + vec2i(1, 0)), part.x);
    let south = mix(engine_texel(texel + vec2i(0, 1)), engine_texel(texel + vec2i(1, 1)), part.x);
    return mix(north, south, part.y);
}

@vertex
fn engine_vertex(@builtin(vertex_index) vertex: u32, @builtin(instance_index) instance: u32) -> EngineVertex {
    var corners = array(vec2u(0, 0), vec2u(0, 1), vec2u(1, 0), vec2u(1, 0), vec2u(0, 1), vec2u(1, 1));
    let quad = vertex / 6u;
    let grid = vec2u(quad % ENGINE_QUADS, quad / ENGINE_QUADS) + corners[vertex % 6u];
    let cell = vec2u(instance % engine_view.columns, instance / engine_view.columns);
    let local = vec2f(grid) / f32(ENGINE_QUADS) * engine_view.patch_size;
    let xz = vec2f(cell) * engine_view.patch_size + local;
    let height = engine_height(xz);
    let clip = engine_view.clip * vec4f(xz.x, height, xz.y, 1.0);
    return EngineVertex(clip, vec3f(local.x, height, local.y), cell);
}

fn engine_ground(vertex: EngineVertex, local_dx: vec3f, local_dy: vec3f) -> EngineGround {
    let xz = vec2f(vertex.cell) * engine_view.patch_size + vertex.local.xz;
    let step = engine_view.size / vec2f(textureDimensions(engine_heights));
    let here = engine_height(xz);
    let west = engine_height(xz - vec2f(step.x, 0.0));
    let east = engine_height(xz + vec2f(step.x, 0.0));
    let north = engine_height(xz - vec2f(0.0, step.y));
    let south = engine_height(xz + vec2f(0.0, step.y));
    let bend = vec2f(west + east - 2.0 * here, north + south - 2.0 * here) / (step * step);
    var ground: EngineGround;
    ground.corner = vec2i(vertex.cell) * engine_view.patch_fixed;
    ground.local = vertex.local;
    ground.local_dx = local_dx;
    ground.local_dy = local_dy;
    ground.uv = xz / engine_view.size;
    ground.uv_dx = local_dx.xz / engine_view.size;
    ground.uv_dy = local_dy.xz / engine_view.size;
    ground.normal = normalize(vec3f((west - east) / (2.0 * step.x), 1.0, (north - south) / (2.0 * step.y)));
    ground.curvature = -0.5 * (bend.x + bend.y);
    ground.distance = distance(engine_view.eye, vec3f(xz.x, vertex.local.y, xz.y));
    ground.sun = engine_view.sun;
    return ground;
}

@fragment
fn engine_fragment(vertex: EngineVertex) -> @location(0) vec4f {
    // Derivatives belong here, where control flow is uniform; the material asks for none.
    let ground = engine_ground(vertex, dpdx(vertex.local), dpdy(vertex.local));
    let material = engine_material(ground);

    // Tangent space: x along the ground to the east, y along the ground to the south, z out of it.
    let east = normalize(vec3f(ground.normal.y, -ground.normal.x, 0.0));
    let south = cross(east, ground.normal);
    let normal = normalize(mat3x3f(east, south, ground.normal) * material.normal);

    let sun = 3.0 * max(dot(normal, engine_view.sun), 0.0) * vec3f(1.0, 0.94, 0.84);
    let sky = (0.5 + 0.5 * normal.y) * material.occlusion * vec3f(0.35, 0.45, 0.62);
    let lit = material.albedo * (sun + sky) + material.emissive;
    let air = 1.0 - exp(-ground.distance / 9000.0);
    return vec4f(1.0 - exp(-mix(lit, vec3f(0.42, 0.55, 0.75), air)), 1.0);
}
