//! One method over one map on one device.

use std::time::{Duration, Instant};

use bytemuck::{Pod, Zeroable};
use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;
use terrane_shaderlib::heightfield::Heights;
use wgpu::util::{BufferInitDescriptor, DeviceExt as _, TextureDataOrder};

use super::method::Method;
use super::placed::Placed;
use super::setup::{DeviceRay, Segment, Setup};
use crate::render::{Gpu, RenderError};

/// What became of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// Nothing in its range.
    Miss,
    /// The ground, at t.
    Hit(f64),
    /// The search was given up.
    Unresolved,
}

/// A ray's outcome and what it cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Traced {
    /// What became of it.
    pub outcome: Outcome,
    /// Nodes visited, or samples taken.
    pub steps: u32,
    /// Patches intersected, four texels each.
    pub leaves: u32,
}

/// A method, ready to trace.
#[derive(Debug)]
pub struct Tracer<'a> {
    gpu: &'a Gpu,
    heights: &'a Heights,
    range: [f64; 2],
    pipeline: wgpu::ComputePipeline,
    textures: [wgpu::TextureView; 2],
    field: wgpu::Buffer,
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct DeviceHit {
    t: f32,
    state: u32,
    cell: [i32; 2],
    steps: u32,
    leaves: u32,
}

const HOST: &str = "
struct ReliefStored { cell: vec2i, origin: vec3f, direction: vec3f, end: f32 }
@group(0) @binding(0) var<uniform> relief_field: ReliefField;
@group(0) @binding(1) var<storage, read> relief_rays: array<ReliefStored>;
@group(0) @binding(2) var<storage, read_write> relief_hits: array<ReliefHit>;
@group(0) @binding(3) var relief_heights: texture_2d<u32>;
@group(0) @binding(4) var relief_bounds: texture_2d<u32>;

@compute @workgroup_size(64)
fn relief_main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let index = id.x + id.y * groups.x * 64u;
    if index < arrayLength(&relief_rays) {
        let stored = relief_rays[index];
        let ray = ReliefRay(stored.cell, stored.origin, stored.direction, stored.end);
        relief_hits[index] = CALL;
    }
}
";

/// Work groups in a row of a dispatch: WebGPU promises 65535.
const ROW: usize = 32_768;

impl<'a> Tracer<'a> {
    /// Uploads the map and compiles the method. After `limit` nodes a search is given up.
    ///
    /// # Errors
    /// [`RenderError::Refused`] where the device takes no part of it.
    pub fn new(
        gpu: &'a Gpu,
        heights: &'a Heights,
        placed: &Placed,
        method: Method,
        limit: u32,
    ) -> Result<Self, RenderError> {
        let ([wrap_x, wrap_y], [last_x, last_y]) = (placed.wrap, placed.last);
        let field = [wrap_x, wrap_y, last_x, last_y, placed.bounds.len() as i32 - 1, limit as i32, 0, 0];
        let pipeline = gpu.checked("relief's pipeline", || pipeline(gpu, &shader(method)))?;
        gpu.checked("relief's data", || Self {
            gpu,
            heights,
            range: placed.range,
            pipeline,
            textures: [
                texture(gpu, placed.size, std::slice::from_ref(&placed.texels)),
                texture(gpu, placed.size, &placed.bounds),
            ],
            field: gpu.device.create_buffer_init(&BufferInitDescriptor {
                label: Some("relief's field"),
                contents: bytemuck::cast_slice(&field),
                usage: wgpu::BufferUsages::UNIFORM,
            }),
        })
    }

    /// Traces rays, each in its range of t, and says how long the device took, all cores together where it is a CPU.
    ///
    /// # Errors
    /// [`RenderError::Lost`] where the device fails.
    pub fn trace(&self, segments: &[Segment]) -> Result<(Vec<Traced>, Duration), RenderError> {
        let setup = |segment| Setup::new(self.heights, self.range, segment);
        let setups: Vec<Option<Setup>> = segments.iter().map(setup).collect();
        let sent: Vec<DeviceRay> = setups.iter().flatten().map(|setup| setup.ray).collect();
        let (hits, time) = if sent.is_empty() { (Vec::new(), Duration::ZERO) } else { self.run(&sent)? };
        let mut hits = hits.iter();
        let traced = setups.iter().map(|setup| {
            let found = setup.as_ref().and_then(|setup| hits.next().map(|hit| traced(setup, hit)));
            found.unwrap_or(Traced { outcome: Outcome::Miss, steps: 0, leaves: 0 })
        });
        Ok((traced.collect(), time))
    }

    fn run(&self, rays: &[DeviceRay]) -> Result<(Vec<DeviceHit>, Duration), RenderError> {
        let device = &self.gpu.device;
        let size = (rays.len() * size_of::<DeviceHit>()) as u64;
        let sent = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("rays"),
            contents: bytemuck::cast_slice(rays),
            usage: wgpu::BufferUsages::STORAGE,
        });
        let buffer = |usage| wgpu::BufferDescriptor { label: Some("hits"), size, usage, mapped_at_creation: false };
        let found = device.create_buffer(&buffer(wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC));
        let read = device.create_buffer(&buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ));
        let group = self.bind([&sent, &found]);
        self.gpu.wait()?;
        let start = Instant::now();
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &group, &[]);
            let groups = rays.len().div_ceil(64);
            pass.dispatch_workgroups(groups.min(ROW) as u32, groups.div_ceil(ROW) as u32, 1);
        }
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.wait()?;
        let time = start.elapsed();
        Ok((self.read(&found, &read)?, time))
    }

    fn bind(&self, [rays, hits]: [&wgpu::Buffer; 2]) -> wgpu::BindGroup {
        let buffers = [&self.field, rays, hits].map(|buffer| buffer.as_entire_binding());
        let textures = self.textures.each_ref().map(wgpu::BindingResource::TextureView);
        let resources = buffers.into_iter().chain(textures).enumerate();
        let entries: Vec<_> =
            resources.map(|(binding, resource)| wgpu::BindGroupEntry { binding: binding as u32, resource }).collect();
        self.gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("relief"),
            layout: &self.pipeline.get_bind_group_layout(0),
            entries: &entries,
        })
    }

    fn read(&self, found: &wgpu::Buffer, read: &wgpu::Buffer) -> Result<Vec<DeviceHit>, RenderError> {
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(found, 0, read, 0, read.size());
        self.gpu.queue.submit([encoder.finish()]);
        Ok(self.gpu.read(read)?.chunks_exact(size_of::<DeviceHit>()).map(bytemuck::pod_read_unaligned).collect())
    }
}

fn traced(setup: &Setup, hit: &DeviceHit) -> Traced {
    let outcome = match hit.state {
        0 if setup.is_cut => Outcome::Unresolved,
        0 => Outcome::Miss,
        1 => Outcome::Hit(setup.t(hit.t)),
        _ => Outcome::Unresolved,
    };
    Traced { outcome, steps: hit.steps, leaves: hit.leaves }
}

/// WGSL that traces rays from a buffer by a method: an entry point, and what it needs of the library.
#[must_use]
pub fn shader(method: Method) -> String {
    let library =
        Library::load(&mut Sources::default(), &[]).expect("the shipped library is right, which its tests show");
    let host = HOST.replace("CALL", &method.call());
    let items = library.closure(&host);
    let declarations = items.iter().map(|item| library.slice(*item).to_owned() + "\n");
    declarations.chain([host.clone()]).collect()
}

fn pipeline(gpu: &Gpu, text: &str) -> wgpu::ComputePipeline {
    let module = module(gpu, text);
    let entries: Vec<_> = (0..5).map(entry).collect();
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

fn entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    let buffer = |ty| wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    let ty = match binding {
        0 => buffer(wgpu::BufferBindingType::Uniform),
        1 => buffer(wgpu::BufferBindingType::Storage { read_only: true }),
        2 => buffer(wgpu::BufferBindingType::Storage { read_only: false }),
        _ => wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Uint,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
    };
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::COMPUTE, ty, count: None }
}

fn texture(gpu: &Gpu, [width, height]: [u32; 2], levels: &[Vec<u16>]) -> wgpu::TextureView {
    let descriptor = wgpu::TextureDescriptor {
        label: Some("relief"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: levels.len() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::R16Uint,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    };
    let texels: Vec<u16> = levels.concat();
    let bytes = bytemuck::cast_slice(&texels);
    let texture = gpu.device.create_texture_with_data(&gpu.queue, &descriptor, TextureDataOrder::LayerMajor, bytes);
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
