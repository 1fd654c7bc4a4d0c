//! How long a device takes.

use std::time::{Duration, Instant};

use cpu_time::ProcessTime;

use crate::render::Gpu;

/// A clock that runs. On a software device it counts what this process spends on all cores: there the wall's clock wanders by
/// a third with whatever else the machine does, and this one by a hundredth.
pub(super) enum Clock {
    Process(ProcessTime),
    Wall(Instant),
}

impl Clock {
    /// Starts one for a device.
    pub(super) fn start(gpu: &Gpu) -> Self {
        match ProcessTime::try_now() {
            Ok(now) if gpu.is_software() => Self::Process(now),
            _ => Self::Wall(Instant::now()),
        }
    }

    /// Since it was started.
    pub(super) fn elapsed(&self) -> Duration {
        match self {
            Self::Process(start) => start.try_elapsed().unwrap_or_default(),
            Self::Wall(start) => start.elapsed(),
        }
    }
}
