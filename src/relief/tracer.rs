//! One method over one map on one device.

use std::time::Duration;

use bytemuck::{Pod, Zeroable};
use terrane_shaderlib::heightfield::Heights;
use terrane_shaderlib::relief::{Method, Placed};
use wgpu::util::{BufferInitDescriptor, DeviceExt as _};

use super::clock::{Clock, Timing};
use super::setup::{DeviceRay, Segment, Setup};
use super::shader::{COLUMNS, pipeline, shader, tiled_shader};
use super::texture::{self, textures};
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
    /// The cell that was hit, unwrapped as that of [`terrane_shaderlib::heightfield::Hit`]; 0 where none was.
    pub cell: [i64; 2],
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
    timing: Timing,
    method: Method,
    tiled: bool,
    pipeline: wgpu::ComputePipeline,
    textures: [wgpu::TextureView; 2],
    field: wgpu::Buffer,
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct DeviceHit {
    pub(super) t: f32,
    pub(super) state: u32,
    cell: [i32; 2],
    pub(super) steps: u32,
    pub(super) leaves: u32,
}

/// Work groups in a row of a dispatch: WebGPU promises 65535.
const ROW: usize = 32_768;

/// Rows of rays that are sent at once: what WebGPU promises for a texture.
const ROWS: usize = 8192;

impl<'a> Tracer<'a> {
    /// Uploads the map and compiles the method; `placed` is the map with the bounds of the method.
    ///
    /// # Errors
    /// [`RenderError::Refused`] where the device takes no part of it.
    pub fn new(gpu: &'a Gpu, heights: &'a Heights, placed: &Placed, method: Method) -> Result<Self, RenderError> {
        Self::compiled(gpu, heights, placed, method, &text(method, placed.tiled))
    }

    /// The same for any text with the entry point and the bindings of a method's, over that method's bounds.
    pub(super) fn compiled(
        gpu: &'a Gpu,
        heights: &'a Heights,
        placed: &Placed,
        method: Method,
        text: &str,
    ) -> Result<Self, RenderError> {
        let pipeline = gpu.checked("relief's pipeline", || pipeline(gpu, method, text))?;
        Self::with(gpu, heights, placed, method, pipeline)
    }

    /// The same method over another map, which need not be compiled again unless it differs in whether it is traced tile by
    /// tile.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn over<'b>(&self, heights: &'b Heights, placed: &Placed) -> Result<Tracer<'b>, RenderError>
    where
        'a: 'b,
    {
        if self.tiled != placed.tiled {
            return Tracer::new(self.gpu, heights, placed, self.method);
        }
        Tracer::with(self.gpu, heights, placed, self.method, self.pipeline.clone())
    }

    fn with(
        gpu: &'a Gpu,
        heights: &'a Heights,
        placed: &Placed,
        method: Method,
        pipeline: wgpu::ComputePipeline,
    ) -> Result<Self, RenderError> {
        gpu.checked("relief's data", || Self {
            gpu,
            heights,
            range: placed.range,
            timing: Timing::of(gpu),
            method,
            tiled: placed.tiled,
            pipeline,
            textures: [textures(gpu, &[&placed.heights]), textures(gpu, &[&placed.bounds])],
            field: gpu.device.create_buffer_init(&BufferInitDescriptor {
                label: Some("relief's field"),
                contents: bytemuck::cast_slice(&placed.fields[0].words()),
                usage: wgpu::BufferUsages::UNIFORM,
            }),
        })
    }

    /// Another method with the same bounds, over the same map: what was uploaded serves both.
    ///
    /// # Errors
    /// [`RenderError::Refused`] where the device does not take the method.
    pub fn sharing(&self, method: Method) -> Result<Self, RenderError> {
        let text = text(method, self.tiled);
        let pipeline = self.gpu.checked("relief's pipeline", || pipeline(self.gpu, method, &text))?;
        Ok(Self { method, pipeline, textures: self.textures.clone(), field: self.field.clone(), ..*self })
    }

    /// The same with its time taken otherwise; [`Timing::Device`] needs [`Gpu::has_timestamps`].
    #[must_use]
    pub fn timed(self, timing: Timing) -> Self {
        Self { timing, ..self }
    }

    /// Traces rays, each in its range of t, and says how long the device took, all cores together where it is a CPU.
    ///
    /// # Errors
    /// [`RenderError::Lost`] where the device fails.
    pub fn trace(&self, segments: &[Segment]) -> Result<(Vec<Traced>, Duration), RenderError> {
        let setup = |segment| Setup::new(self.heights, self.range, segment);
        let setups: Vec<Option<Setup>> = segments.iter().map(setup).collect();
        let sent: Vec<DeviceRay> = setups.iter().flatten().map(|setup| setup.ray).collect();
        let (hits, time) = self.run(&sent)?;
        let mut hits = hits.iter();
        let traced = setups.iter().map(|setup| {
            let found = setup.as_ref().and_then(|setup| hits.next().map(|hit| traced(setup, hit)));
            found.unwrap_or(Traced { outcome: Outcome::Miss, cell: [0; 2], steps: 0, leaves: 0 })
        });
        Ok((traced.collect(), time))
    }

    /// One answer for each ray.
    pub(super) fn run(&self, rays: &[DeviceRay]) -> Result<(Vec<DeviceHit>, Duration), RenderError> {
        let (mut hits, mut time) = (Vec::new(), Duration::ZERO);
        for part in rays.chunks(ROWS * COLUMNS) {
            let (found, took) = self.run_part(part)?;
            hits.extend(found);
            time += took;
        }
        Ok((hits, time))
    }

    /// The same for as many as one texture holds.
    fn run_part(&self, rays: &[DeviceRay]) -> Result<(Vec<DeviceHit>, Duration), RenderError> {
        let device = &self.gpu.device;
        let size = (rays.len() * size_of::<DeviceHit>()) as u64;
        let sent = self.gpu.checked("rays", || texture::rays(self.gpu, rays))?;
        let buffer = |usage| wgpu::BufferDescriptor { label: Some("hits"), size, usage, mapped_at_creation: false };
        let found = device.create_buffer(&buffer(wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC));
        let read = device.create_buffer(&buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ));
        let group = self.bind(&sent, &found);
        self.gpu.wait()?;
        let clock = Clock::start(self.gpu, self.timing);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let descriptor = wgpu::ComputePassDescriptor { label: Some("relief"), timestamp_writes: clock.writes() };
            let mut pass = encoder.begin_compute_pass(&descriptor);
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &group, &[]);
            let groups = rays.len().div_ceil(64);
            pass.dispatch_workgroups(groups.min(ROW) as u32, groups.div_ceil(ROW) as u32, 1);
        }
        clock.resolve(&mut encoder);
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.wait()?;
        let time = clock.elapsed(self.gpu)?;
        Ok((self.read(&found, &read)?, time))
    }

    fn bind(&self, rays: &wgpu::TextureView, hits: &wgpu::Buffer) -> wgpu::BindGroup {
        let [heights, bounds] = self.textures.each_ref().map(wgpu::BindingResource::TextureView);
        let rays = wgpu::BindingResource::TextureView(rays);
        let resources = [self.field.as_entire_binding(), rays, hits.as_entire_binding(), heights, bounds];
        let resources = resources.into_iter().enumerate();
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

/// A method's shader, over a map that is traced whole or tile by tile.
fn text(method: Method, tiled: bool) -> String {
    if tiled { tiled_shader(method) } else { shader(method) }
}

fn traced(setup: &Setup, hit: &DeviceHit) -> Traced {
    let outcome = match hit.state {
        0 if setup.is_cut => Outcome::Unresolved,
        0 => Outcome::Miss,
        1 => Outcome::Hit(setup.t(hit.t)),
        _ => Outcome::Unresolved,
    };
    let cell = if hit.state == 1 { setup.cell(hit.cell) } else { [0; 2] };
    Traced { outcome, cell, steps: hit.steps, leaves: hit.leaves }
}
