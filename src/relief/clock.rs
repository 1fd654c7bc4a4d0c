//! How long a device takes.

use std::fmt;
use std::time::{Duration, Instant};

use cpu_time::ProcessTime;
use terrane_shaderlib::relief::Platform;

use crate::render::{Gpu, RenderError};

/// What counts as the time of a trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timing {
    /// What this process spends on all cores. On a software device the wall's clock wanders by a third with whatever else the
    /// machine does, and this one by a hundredth.
    Processor,
    /// Timestamps that the device itself takes before and after.
    Device,
    /// From the submission until the device is done.
    Wall,
}

impl Timing {
    /// The best that a device has.
    #[must_use]
    pub fn of(gpu: &Gpu) -> Self {
        if gpu.platform() == Platform::Cpu && ProcessTime::try_now().is_ok() {
            Self::Processor
        } else if gpu.has_timestamps() {
            Self::Device
        } else {
            Self::Wall
        }
    }
}

impl fmt::Display for Timing {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(match self {
            Self::Processor => "processor",
            Self::Device => "device",
            Self::Wall => "wall",
        })
    }
}

/// A clock that runs.
pub(super) enum Clock {
    Processor(ProcessTime),
    Device(Timestamps),
    Wall(Instant),
}

impl Clock {
    /// Starts one. A processor's time that cannot be had is the wall's.
    pub(super) fn start(gpu: &Gpu, timing: Timing) -> Self {
        match (timing, ProcessTime::try_now()) {
            (Timing::Processor, Ok(now)) => Self::Processor(now),
            (Timing::Device, _) => Self::Device(Timestamps::new(gpu)),
            _ => Self::Wall(Instant::now()),
        }
    }

    /// What the pass that is timed writes.
    pub(super) fn writes(&self) -> Option<wgpu::ComputePassTimestampWrites<'_>> {
        let Self::Device(stamps) = self else { return None };
        Some(wgpu::ComputePassTimestampWrites {
            query_set: &stamps.set,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        })
    }

    /// Makes what was written readable, behind the pass.
    pub(super) fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        if let Self::Device(stamps) = self {
            encoder.resolve_query_set(&stamps.set, 0..2, &stamps.resolved, 0);
            encoder.copy_buffer_to_buffer(&stamps.resolved, 0, &stamps.read, 0, STAMPS);
        }
    }

    /// Since it was started, once the device is done.
    pub(super) fn elapsed(&self, gpu: &Gpu) -> Result<Duration, RenderError> {
        match self {
            Self::Processor(start) => Ok(start.try_elapsed().unwrap_or_default()),
            Self::Device(stamps) => stamps.elapsed(gpu),
            Self::Wall(start) => Ok(start.elapsed()),
        }
    }
}

/// Bytes of two timestamps.
const STAMPS: u64 = 16;

/// Timestamps around one pass.
pub(super) struct Timestamps {
    set: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    read: wgpu::Buffer,
}

impl Timestamps {
    fn new(gpu: &Gpu) -> Self {
        let buffer = |usage| {
            let descriptor =
                wgpu::BufferDescriptor { label: Some("timestamps"), size: STAMPS, usage, mapped_at_creation: false };
            gpu.device.create_buffer(&descriptor)
        };
        let set = wgpu::QuerySetDescriptor { label: Some("timestamps"), ty: wgpu::QueryType::Timestamp, count: 2 };
        Self {
            set: gpu.device.create_query_set(&set),
            resolved: buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC),
            read: buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ),
        }
    }

    fn elapsed(&self, gpu: &Gpu) -> Result<Duration, RenderError> {
        let bytes = gpu.read(&self.read)?;
        let stamps: Vec<u64> = bytes.chunks_exact(8).map(bytemuck::pod_read_unaligned).collect();
        let ticks = stamps[1].saturating_sub(stamps[0]) as f64;
        Ok(Duration::from_secs_f64(ticks * f64::from(gpu.queue.get_timestamp_period()) * 1e-9))
    }
}
