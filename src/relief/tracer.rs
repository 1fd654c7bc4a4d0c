//! One method over one map on one device.

use std::time::Duration;

use bytemuck::{Pod, Zeroable};
use terrane_shaderlib::heightfield::Heights;
use terrane_shaderlib::relief::{Method, Placed};
use wgpu::util::{BufferInitDescriptor, DeviceExt as _};

use super::clock::{Clock, Timing};
use super::sent::{Part, Sent};
use super::setup::{DeviceRay, Segment};
use super::shader::{Pipelines, shader, tiled_shader};
use super::texture::textures;
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
    pipelines: Pipelines,
    textures: [wgpu::TextureView; 2],
    field: wgpu::Buffer,
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct DeviceHit {
    pub(super) t: f32,
    pub(super) state: u32,
    pub(super) cell: [i32; 2],
    pub(super) steps: u32,
    pub(super) leaves: u32,
}

/// What a GPU's timestamps are taken around, at least.
const LONG_ENOUGH: Duration = Duration::from_millis(5);

/// Passes at most.
const MOST: u32 = 10_000;

impl<'a> Tracer<'a> {
    /// Uploads the map and compiles the method; `placed` is the map with the bounds of the method.
    ///
    /// # Errors
    /// [`RenderError::Refused`] where the device takes no part of it.
    pub fn new(gpu: &'a Gpu, heights: &'a Heights, placed: &Placed, method: Method) -> Result<Self, RenderError> {
        Self::compiled(gpu, heights, placed, method, &text(method, placed.tiled))
    }

    /// The same for any text with the entry points and the bindings of a method's, over that method's bounds.
    pub(super) fn compiled(
        gpu: &'a Gpu,
        heights: &'a Heights,
        placed: &Placed,
        method: Method,
        text: &str,
    ) -> Result<Self, RenderError> {
        let pipelines = compiled(gpu, method, text)?;
        Self::with(gpu, heights, placed, method, pipelines)
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
        Tracer::with(self.gpu, heights, placed, self.method, self.pipelines.clone())
    }

    fn with(
        gpu: &'a Gpu,
        heights: &'a Heights,
        placed: &Placed,
        method: Method,
        pipelines: Pipelines,
    ) -> Result<Self, RenderError> {
        gpu.checked("relief's data", || Self {
            gpu,
            heights,
            range: placed.range,
            timing: Timing::of(gpu),
            method,
            tiled: placed.tiled,
            pipelines,
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
        let pipelines = compiled(self.gpu, method, &text(method, self.tiled))?;
        Ok(Self { method, pipelines, textures: self.textures.clone(), field: self.field.clone(), ..*self })
    }

    /// The same with its time taken otherwise; [`Timing::Device`] needs [`Gpu::has_timestamps`].
    #[must_use]
    pub fn timed(self, timing: Timing) -> Self {
        Self { timing, ..self }
    }

    /// Uploads rays, each with its range of t. What is sent by one method may be traced by any other over the same map.
    ///
    /// # Errors
    /// [`RenderError::Refused`] where the device has no room for them.
    pub fn send(&self, segments: &[Segment]) -> Result<Sent, RenderError> {
        Sent::new(self.gpu, self.heights, self.range, segments)
    }

    /// How long the device takes to load each ray that was sent, trace it and write t alone, all cores together where it is a CPU.
    ///
    /// # Errors
    /// [`RenderError::Lost`] where the device fails.
    pub fn time(&self, sent: &Sent) -> Result<Duration, RenderError> {
        sent.parts.iter().map(|part| self.time_part(part, self.pipelines.timed())).sum()
    }

    /// What it finds of what was sent.
    ///
    /// # Errors
    /// [`RenderError::Lost`] where the device fails.
    pub fn find(&self, sent: &Sent) -> Result<Vec<Traced>, RenderError> {
        for part in &sent.parts {
            self.time_passes(part, &self.pipelines.answers, &self.bind(part), 1)?;
        }
        sent.read(self.gpu)
    }

    /// Sends rays, traces them and reads what was found, with the time that it takes to write that.
    ///
    /// # Errors
    /// Those of [`Self::send`] and [`Self::time`].
    pub fn trace(&self, segments: &[Segment]) -> Result<(Vec<Traced>, Duration), RenderError> {
        let sent = self.send(segments)?;
        let times = sent.parts.iter().map(|part| self.time_part(part, &self.pipelines.answers));
        let time = times.sum::<Result<_, _>>()?;
        Ok((sent.read(self.gpu)?, time))
    }

    /// One answer for each ray.
    pub(super) fn run(&self, rays: &[DeviceRay]) -> Result<(Vec<DeviceHit>, Duration), RenderError> {
        let (mut hits, mut time) = (Vec::new(), Duration::ZERO);
        for part in Part::all(self.gpu, rays)? {
            time += self.time_part(&part, &self.pipelines.answers)?;
            hits.extend(part.read(self.gpu)?);
        }
        Ok((hits, time))
    }

    /// A GPU that waited has slowed down, and its clock is coarse: it traces more and more often, until that takes long enough
    /// to be believed.
    fn time_part(&self, part: &Part, pipeline: &wgpu::ComputePipeline) -> Result<Duration, RenderError> {
        let group = self.bind(part);
        let mut times = 1;
        loop {
            let took = self.time_passes(part, pipeline, &group, times)?;
            if self.timing != Timing::Device || took >= LONG_ENOUGH || times == MOST {
                return Ok(took / times);
            }
            let more = 1.5 * LONG_ENOUGH.as_secs_f64() / took.as_secs_f64().max(1e-6);
            times = (f64::from(times) * more).ceil().min(f64::from(MOST)) as u32;
        }
    }

    fn time_passes(
        &self,
        part: &Part,
        pipeline: &wgpu::ComputePipeline,
        group: &wgpu::BindGroup,
        times: u32,
    ) -> Result<Duration, RenderError> {
        self.gpu.wait()?;
        let clock = Clock::start(self.gpu, self.timing);
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        part.record(&mut encoder, (pipeline, group), &clock, times);
        clock.resolve(&mut encoder);
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.wait()?;
        clock.elapsed(self.gpu)
    }

    fn bind(&self, Part { rays, hits, ends, .. }: &Part) -> wgpu::BindGroup {
        let [heights, bounds] = self.textures.each_ref().map(wgpu::BindingResource::TextureView);
        let rays = wgpu::BindingResource::TextureView(rays);
        let [field, hits, ends] = [&self.field, hits, ends].map(wgpu::Buffer::as_entire_binding);
        let resources = [field, rays, hits, heights, bounds, ends];
        let resources = resources.into_iter().enumerate();
        let entries: Vec<_> =
            resources.map(|(binding, resource)| wgpu::BindGroupEntry { binding: binding as u32, resource }).collect();
        self.gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("relief"),
            layout: &self.pipelines.group,
            entries: &entries,
        })
    }
}

fn compiled(gpu: &Gpu, method: Method, text: &str) -> Result<Pipelines, RenderError> {
    gpu.checked("relief's pipeline", || Pipelines::new(gpu, method, text))
}

/// A method's shader, over a map that is traced whole or tile by tile.
fn text(method: Method, tiled: bool) -> String {
    if tiled { tiled_shader(method) } else { shader(method) }
}
