//! Rays on a device, and the room for their answers.

use bytemuck::AnyBitPattern;
use rayon::prelude::*;
use terrane_shaderlib::heightfield::Heights;

use super::clock::Clock;
use super::setup::{DeviceRay, Segment, Setup};
use super::shader::COLUMNS;
use super::texture;
use super::tracer::{DeviceHit, Outcome, Traced};
use crate::render::{Gpu, RenderError};

/// Rays over one map. Every method over that map may trace them, one after the other.
#[derive(Debug)]
pub struct Sent {
    setups: Vec<Option<Setup>>,
    pub(super) parts: Vec<Part>,
}

/// As many rays as one texture holds.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) count: usize,
    pub(super) rays: wgpu::TextureView,
    pub(super) hits: wgpu::Buffer,
    /// t of each, where nothing else is asked for.
    pub(super) ends: wgpu::Buffer,
}

/// Rows of rays that are sent at once: what WebGPU promises for a texture.
const ROWS: usize = 8192;

/// Work groups in a row of a dispatch: WebGPU promises 65535.
const ROW: usize = 32_768;

impl Sent {
    /// Prepares rays, each in its range of t, and uploads them; `range` is the map's lowest and highest height.
    pub(super) fn new(
        gpu: &Gpu,
        heights: &Heights,
        range: [f64; 2],
        segments: &[Segment],
    ) -> Result<Self, RenderError> {
        let setups: Vec<Option<Setup>> =
            segments.par_iter().map(|segment| Setup::new(heights, range, segment)).collect();
        let rays: Vec<DeviceRay> = setups.iter().flatten().map(|setup| setup.ray).collect();
        Ok(Self { setups, parts: Part::all(gpu, &rays)? })
    }

    /// What the method found that traced them last.
    pub(super) fn read(&self, gpu: &Gpu) -> Result<Vec<Traced>, RenderError> {
        let mut hits = Vec::new();
        for part in &self.parts {
            hits.extend(part.read(gpu)?);
        }
        let mut hits = hits.iter();
        let traced = self.setups.iter().map(|setup| {
            let found = setup.as_ref().and_then(|setup| hits.next().map(|hit| traced(setup, hit)));
            found.unwrap_or(Traced { outcome: Outcome::Miss, cell: [0; 2], steps: 0, leaves: 0 })
        });
        Ok(traced.collect())
    }
}

impl Part {
    /// Uploads rays.
    pub(super) fn all(gpu: &Gpu, rays: &[DeviceRay]) -> Result<Vec<Self>, RenderError> {
        rays.chunks(ROWS * COLUMNS).map(|part| Self::new(gpu, part)).collect()
    }

    fn new(gpu: &Gpu, rays: &[DeviceRay]) -> Result<Self, RenderError> {
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let buffer = |size: usize| {
            let size = (rays.len() * size) as u64;
            let descriptor = wgpu::BufferDescriptor { label: Some("answers"), size, usage, mapped_at_creation: false };
            gpu.device.create_buffer(&descriptor)
        };
        gpu.checked("rays", || Self {
            count: rays.len(),
            rays: texture::rays(gpu, rays),
            hits: buffer(size_of::<DeviceHit>()),
            ends: buffer(size_of::<f32>()),
        })
    }

    /// Traces them so many times in one pass.
    pub(super) fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        (pipeline, group): (&wgpu::ComputePipeline, &wgpu::BindGroup),
        clock: &Clock,
        times: u32,
    ) {
        let descriptor = wgpu::ComputePassDescriptor { label: Some("relief"), timestamp_writes: clock.writes() };
        let mut pass = encoder.begin_compute_pass(&descriptor);
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, group, &[]);
        let groups = self.count.div_ceil(64);
        for _ in 0..times {
            pass.dispatch_workgroups(groups.min(ROW) as u32, groups.div_ceil(ROW) as u32, 1);
        }
    }

    /// One answer for each ray.
    pub(super) fn read(&self, gpu: &Gpu) -> Result<Vec<DeviceHit>, RenderError> {
        copied(gpu, &self.hits)
    }
}

/// What a buffer holds.
fn copied<T: AnyBitPattern>(gpu: &Gpu, from: &wgpu::Buffer) -> Result<Vec<T>, RenderError> {
    let (size, usage) = (from.size(), wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ);
    let read = wgpu::BufferDescriptor { label: Some("answers"), size, usage, mapped_at_creation: false };
    let read = gpu.device.create_buffer(&read);
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_buffer_to_buffer(from, 0, &read, 0, size);
    gpu.queue.submit([encoder.finish()]);
    Ok(gpu.read(&read)?.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned).collect())
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

#[cfg(test)]
mod tests {
    use terrane_shaderlib::heightfield::adversary::{Depth, Land, map};
    use terrane_shaderlib::heightfield::{Border, Ray};
    use terrane_shaderlib::relief::{Method, Placed};

    use super::*;
    use crate::relief::{Segment, Tracer};
    use crate::render::Selection;

    #[test]
    fn what_is_timed_is_the_search_that_answers() {
        let Ok(gpu) = Gpu::new(&Selection::Best) else { return println!("skipped: no device") };
        let heights = map(Land::Hills, [64, 64], Border::Wrap, Depth::Sixteen, 3).expect("a map");
        let rays = (0..200).map(|index| {
            let ray = Ray { origin: [0.3 * f64::from(index), 7.1, 65_535.0], direction: [1.0, 0.4, -3000.0] };
            Segment { ray, range: (0.0, 30.0) }
        });
        for method in [Method::MaximumMipmaps, Method::Leap] {
            let placed = Placed::new(&heights, method.bounds(), 1 << 16).expect("whole steps");
            let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
            let sent = tracer.send(&rays.clone().collect::<Vec<_>>()).expect("the device takes them");
            tracer.find(&sent).expect("the device answers");
            tracer.time(&sent).expect("the device answers");
            let part = &sent.parts[0];
            let (hits, ends) = (part.read(&gpu).unwrap(), copied::<f32>(&gpu, &part.ends).unwrap());
            let near = hits.iter().zip(&ends).filter(|(hit, end)| hit.state == 1 && (hit.t - **end).abs() < 1e-3);
            assert_eq!(near.count(), 200, "{method}");
        }
    }
}
