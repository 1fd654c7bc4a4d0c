//! What cone maps cost.

use std::time::{Duration, Instant};

use super::map::{ConeMap, Cones};
use crate::heightfield::Heights;

/// What one kind of cone map of a map costs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// Which cones.
    pub cones: Cones,
    /// Bytes for each texel of the map, besides the heights.
    pub bytes_per_texel: f64,
    /// How long all cores took together with whatever else they did: the wall's clock.
    pub time: Duration,
}

/// Builds each kind once.
#[must_use]
pub fn report(heights: &Heights, progress: &(dyn Fn(u64, u64) + Sync)) -> [Report; 3] {
    [Cones::Step, Cones::Relaxed, Cones::Robust].map(|cones| {
        let start = Instant::now();
        let map = ConeMap::new(heights, cones, progress);
        let time = start.elapsed();
        Report { cones, bytes_per_texel: map.bytes() as f64 / map.codes.len() as f64, time }
    })
}
