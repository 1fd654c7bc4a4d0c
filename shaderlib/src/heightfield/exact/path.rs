//! The part of a ray that is worth walking.

use super::axis::Axis;
use crate::heightfield::{Border, Heights, Ray};

/// A ray whose direction is scaled by a power of two, so that its largest component is in 1..2 and nothing under- or
/// overflows; and the times, in the scaled unit, between which there may be ground.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    pub(super) axes: [Axis; 2],
    pub(super) height: f64,
    pub(super) climb: f64,
    pub(super) start: f64,
    pub(super) end: f64,
    /// Two factors: their product may be out of range where each is not.
    unit: [f64; 2],
}

impl Path {
    /// None where there is nothing to walk: no numbers, an empty range, or no ground in it.
    pub(super) fn new(heights: &Heights, ray: &Ray, range: (f64, f64)) -> Option<Self> {
        let finite = ray.origin.iter().chain(&ray.direction).chain([&range.0]).all(|number| number.is_finite());
        if !finite || range.1.is_nan() {
            return None;
        }
        let unit = unit(ray.direction);
        let [x, y, climb] = ray.direction.map(|rate| rate * unit[0] * unit[1]);
        let axes = [Axis::new(ray.origin[0], x)?, Axis::new(ray.origin[1], y)?];
        let [start, end] = [range.0, range.1].map(|t| t / unit[0] / unit[1]);
        let whole = Self { axes, height: ray.origin[2], climb, start, end, unit };
        let path = match heights.border() {
            Border::Clamp => whole.over(heights.size())?,
            Border::Wrap => whole.under_the_top(heights)?,
        };
        (path.start <= path.end).then_some(path)
    }

    /// A time in the ray's own unit.
    pub(super) fn time(&self, t: f64) -> f64 {
        t * self.unit[0] * self.unit[1]
    }

    /// Where a surface ends, so does the path.
    fn over(self, size: [u32; 2]) -> Option<Self> {
        let last = size.map(|side| i64::from(side) - 1);
        let (x, y) = (self.axes[0].inside(last[0])?, self.axes[1].inside(last[1])?);
        Some(Self { start: self.start.max(x.0).max(y.0), end: self.end.min(x.1).min(y.1), ..self })
    }

    /// Without what is above the highest texel. To look for that takes as long as to walk as many cells: only paths
    /// that are longer are worth it, and those without an end need it.
    fn under_the_top(self, heights: &Heights) -> Option<Self> {
        let cells = (self.axes[0].rate().abs() + self.axes[1].rate().abs()) * (self.end - self.start);
        let [width, height] = heights.size().map(f64::from);
        if cells.is_nan() || cells <= width * height {
            return Some(self);
        }
        let top = heights.highest();
        if self.climb == 0.0 {
            return (self.height <= top).then_some(self);
        }
        let crossing = (top - self.height) / self.climb;
        // Far more than the rounding: it costs a few cells, and no hit.
        let slack = 1.0 + 1e-9 * crossing.abs();
        Some(match self.climb > 0.0 {
            true => Self { end: self.end.min(crossing + slack), ..self },
            false => Self { start: self.start.max(crossing - slack), ..self },
        })
    }
}

/// Two powers of two that bring the largest component to 1..2, give or take a rounding of the logarithm.
fn unit(direction: [f64; 3]) -> [f64; 2] {
    let largest = direction.into_iter().fold(0.0, |largest: f64, rate| largest.max(rate.abs()));
    let exponent = if largest == 0.0 { 0 } else { -(largest.log2().floor() as i32) };
    [2_f64.powi(exponent / 2), 2_f64.powi(exponent - exponent / 2)]
}
