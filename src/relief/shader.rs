//! A method as a compute pipeline.

use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;
use terrane_shaderlib::relief::Method;

use crate::render::Gpu;

const HOST: &str = "
@group(0) @binding(0) var<uniform> relief_field: ReliefField;
@group(0) @binding(1) var relief_rays: texture_storage_2d<rgba32uint, read>;
@group(0) @binding(2) var<storage, read_write> relief_hits: array<vec4u>;
@group(0) @binding(3) var relief_heights: HEIGHTS;
@group(0) @binding(4) var relief_bounds: BOUNDS;

@compute @workgroup_size(64)
fn relief_main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index < arrayLength(&relief_hits) {
        let at = vec2u(3u * (index % COLUMNSu), index / COLUMNSu);
        let cell = textureLoad(relief_rays, at);
        let origin = textureLoad(relief_rays, at + vec2u(1u, 0u));
        let along = textureLoad(relief_rays, at + vec2u(2u, 0u));
        let direction = bitcast<vec3f>(along.xyz);
        let ray = ReliefRay(bitcast<vec2i>(cell.xy), bitcast<vec3f>(origin.xyz), direction, bitcast<f32>(along.w));
        let hit = CALL;
        relief_hits[index] = vec4u(bitcast<u32>(hit.t), hit.state, hit.steps, hit.leaves);
    }
}
";

/// Rays in a row of their texture, three texels each.
pub(super) const COLUMNS: usize = 1024;

/// WGSL that traces rays from a texture by a method: an entry point, and what it needs of the library.
#[must_use]
pub fn shader(method: Method) -> String {
    let library =
        Library::load(&mut Sources::default(), &[]).expect("the shipped library is right, which its tests show");
    let [heights, bounds] = method.textures();
    let call = method.call("relief_heights", "relief_bounds", "relief_field", "ray");
    let host = HOST.replace("CALL", &call).replace("HEIGHTS", heights).replace("BOUNDS", bounds);
    let host = host.replace("COLUMNS", &COLUMNS.to_string());
    let items = library.closure(&host);
    let declarations = items.iter().map(|item| library.slice(*item).to_owned() + "\n");
    declarations.chain([host.clone()]).collect()
}

pub(super) fn pipeline(gpu: &Gpu, method: Method) -> wgpu::ComputePipeline {
    let module = module(gpu, &shader(method));
    let entries: Vec<_> = (0..5).map(|binding| entry(method, binding)).collect();
    let group = gpu
        .device
        .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("relief"), entries: &entries });
    let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("relief"),
        bind_group_layouts: &[Some(&group)],
        ..Default::default()
    });
    gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("relief"),
        layout: Some(&layout),
        module: &module,
        entry_point: Some("relief_main"),
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
    // which rays are cut to the map before they are sent.
    unsafe { gpu.device.create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked()) }
}

fn entry(method: Method, binding: u32) -> wgpu::BindGroupLayoutEntry {
    let buffer = |ty| wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    let array = wgpu::TextureViewDimension::D2Array;
    let access = wgpu::StorageTextureAccess::ReadOnly;
    let storage = |format, view_dimension| wgpu::BindingType::StorageTexture { access, format, view_dimension };
    let ty = match (binding, method) {
        (0, _) => buffer(wgpu::BufferBindingType::Uniform),
        (1, _) => storage(wgpu::TextureFormat::Rgba32Uint, wgpu::TextureViewDimension::D2),
        (2, _) => buffer(wgpu::BufferBindingType::Storage { read_only: false }),
        (3, Method::Sprint) => storage(wgpu::TextureFormat::Rg32Uint, array),
        (4, Method::Sprint) => storage(wgpu::TextureFormat::R32Uint, array),
        _ => wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Uint,
            view_dimension: array,
            multisampled: false,
        },
    };
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::COMPUTE, ty, count: None }
}
