//! A method as compute pipelines.

use std::sync::OnceLock;

use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;
use terrane_shaderlib::relief::{MapTexture, Method};

use super::texture;
use crate::render::Gpu;

const HOST: &str = "
@group(0) @binding(0) var<uniform> relief_field: ReliefField;
@group(0) @binding(1) var relief_rays: texture_storage_2d<rgba32uint, read>;
@group(0) @binding(2) var<storage, read_write> relief_hits: array<ReliefHit>;
@group(0) @binding(3) var relief_heights: HEIGHTS;
@group(0) @binding(4) var relief_bounds: BOUNDS;
@group(0) @binding(5) var<storage, read_write> relief_ends: array<f32>;

fn relief_traced(index: u32) -> ReliefHit {
    let at = vec2u(2u * (index % COLUMNSu), index / COLUMNSu);
    let origin = textureLoad(relief_rays, at);
    let along = textureLoad(relief_rays, at + vec2u(1u, 0u));
    let cell = vec2i(vec2u(origin.w & 0xffffu, origin.w >> 16u));
    let ray = ReliefRay(cell, bitcast<vec3f>(origin.xyz), bitcast<vec3f>(along.xyz), bitcast<f32>(along.w));
    return CALL;
}

@compute @workgroup_size(64)
fn relief_main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index < arrayLength(&relief_hits) {
        relief_hits[index] = relief_traced(index);
    }
}

// What a picture asks for: to write a whole answer besides took a GPU up to a third of the time of a method.
@compute @workgroup_size(64)
fn relief_timed(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index < arrayLength(&relief_ends) {
        relief_ends[index] = relief_traced(index).t;
    }
}
";

/// Rays in a row of their texture, two texels each.
pub(super) const COLUMNS: usize = 1024;

const TILED: &str = "
fn relief_found(tiles: ReliefField, whole: ReliefRay) -> ReliefHit {
    var part = tiled_first(tiles, whole);
    var hit: ReliefHit;
    var steps = 0u;
    var leaves = 0u;
    loop {
        hit = relief_over_tile(tiles, part.ray);
        steps += hit.steps;
        leaves += hit.leaves;
        let is_last = part.start + part.ray.end >= whole.end;
        if hit.state != RELIEF_MISS || is_last || steps >= tiles.limit {
            hit.state = select(hit.state, RELIEF_UNRESOLVED, hit.state == RELIEF_MISS && !is_last);
            break;
        }
        part = tiled_next(tiles, whole, part);
    }
    return ReliefHit(part.start + hit.t, hit.state, hit.cell + part.corner, steps, leaves);
}

fn relief_over_tile(tiles: ReliefField, ray: ReliefRay) -> ReliefHit {
    return CALL;
}
";

/// WGSL that traces rays from a texture by a method: two entry points, and what they need of the library.
#[must_use]
pub fn shader(method: Method) -> String {
    with_call(method, &call(method, "relief_field"), "")
}

/// The same over a map that is placed to be traced tile by tile.
#[must_use]
pub fn tiled_shader(method: Method) -> String {
    with_call(method, "relief_found(relief_field, ray)", &TILED.replace("CALL", &call(method, "tiles")))
}

fn call(method: Method, field: &str) -> String {
    method.call("relief_heights", "relief_bounds", field, "ray")
}

/// WGSL over the textures of a method that calls what makes a `ReliefHit` of `ray`, with what `more` declares and what both
/// need of the library.
pub(super) fn with_call(method: Method, call: &str, more: &str) -> String {
    let library =
        Library::load(&mut Sources::default(), &[]).expect("the shipped library is right, which its tests show");
    let [heights, bounds] = textures(method).map(MapTexture::wgsl);
    let host = HOST.replace("HEIGHTS", &heights).replace("BOUNDS", &bounds).replace("COLUMNS", &COLUMNS.to_string());
    let host = host.replace("CALL", call) + more;
    let items = library.closure(&host);
    let declarations = items.iter().map(|item| library.slice(*item).to_owned() + "\n");
    declarations.chain([host.clone()]).collect()
}

/// A method compiled.
#[derive(Clone, Debug)]
pub(super) struct Pipelines {
    device: wgpu::Device,
    module: wgpu::ShaderModule,
    pub(super) group: wgpu::BindGroupLayout,
    layout: wgpu::PipelineLayout,
    /// What writes whole answers.
    pub(super) answers: wgpu::ComputePipeline,
    timed: OnceLock<wgpu::ComputePipeline>,
}

impl Pipelines {
    /// Compiles a method's text; what is timed when it is first asked for.
    pub(super) fn new(gpu: &Gpu, method: Method, text: &str) -> Self {
        let entries: Vec<_> = (0..6).map(|binding| entry(method, binding)).collect();
        let group = gpu
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("relief"), entries: &entries });
        let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("relief"),
            bind_group_layouts: &[Some(&group)],
            ..Default::default()
        });
        let (device, module) = (gpu.device.clone(), module(gpu, text));
        let answers = pipeline(&device, &module, &layout, "relief_main");
        Self { device, module, group, layout, answers, timed: OnceLock::new() }
    }

    /// What writes t alone.
    pub(super) fn timed(&self) -> &wgpu::ComputePipeline {
        self.timed.get_or_init(|| pipeline(&self.device, &self.module, &self.layout, "relief_timed"))
    }
}

fn pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    layout: &wgpu::PipelineLayout,
    entry: &str,
) -> wgpu::ComputePipeline {
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(entry),
        layout: Some(layout),
        module,
        entry_point: Some(entry),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    })
}

/// Without the checks that wgpu would add, which would be measured too: a counter in every loop, a bound on every index.
#[allow(unsafe_code)]
fn module(gpu: &Gpu, text: &str) -> wgpu::ShaderModule {
    let descriptor =
        wgpu::ShaderModuleDescriptor { label: Some("relief"), source: wgpu::ShaderSource::Wgsl(text.into()) };
    // SAFETY: the text is the library's own. Every loop ends: they count nodes up to a limit, or steps. Indices of buffers
    // are compared with their length; texels are masked into a map that wraps, and held inside one that does not, over
    // which rays are cut to the map before they are sent, or where the shader turns them.
    unsafe { gpu.device.create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked()) }
}

fn entry(method: Method, binding: u32) -> wgpu::BindGroupLayoutEntry {
    let buffer = |ty| wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    let ty = match binding {
        0 => buffer(wgpu::BufferBindingType::Uniform),
        1 => wgpu::BindingType::StorageTexture {
            access: wgpu::StorageTextureAccess::ReadOnly,
            format: wgpu::TextureFormat::Rgba32Uint,
            view_dimension: wgpu::TextureViewDimension::D2,
        },
        2 | 5 => buffer(wgpu::BufferBindingType::Storage { read_only: false }),
        3 => texture::binding(textures(method)[0]),
        _ => texture::binding(textures(method)[1]),
    };
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::COMPUTE, ty, count: None }
}

/// What is bound as heights, read or not, and as bounds.
fn textures(method: Method) -> [MapTexture; 2] {
    let bounds = method.bounds();
    [bounds.surface().unwrap_or(MapTexture::Heights), MapTexture::Bounds(bounds)]
}
