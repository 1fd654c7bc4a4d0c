//! From a ray in f64 to what a shader traces.

use std::cmp::Ordering;

use bytemuck::{Pod, Zeroable};
use terrane_shaderlib::heightfield::{Border, Heights, Ray};

/// A ray, and the range of t in which it is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// The ray.
    pub ray: Ray,
    /// From and to.
    pub range: (f64, f64),
}

/// `ReliefRay` of shaderlib/wgsl/relief/relief.wgsl in a storage buffer.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub(super) struct DeviceRay {
    cell: [i32; 2],
    unused: [i32; 2],
    origin: [f32; 3],
    unused_too: f32,
    direction: [f32; 3],
    end: f32,
}

/// A ray ready for the device, and the way back.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Setup {
    pub(super) ray: DeviceRay,
    /// t of the ray where that of the device is 0.
    start: f64,
    /// t of the ray for 1 of the device's.
    scale: f64,
    /// Whether the device's ray ends before that which it stands for: then a miss decides nothing.
    pub(super) is_cut: bool,
}

/// The part of a range in which a ray is over the map.
fn domain(heights: &Heights, ray: &Ray, (mut first, mut last): (f64, f64)) -> Option<(f64, f64)> {
    if heights.border() == Border::Wrap {
        return Some((first, last));
    }
    for (axis, side) in heights.size().into_iter().enumerate() {
        let (at, along, far) = (ray.origin[axis], ray.direction[axis], f64::from(side - 1));
        if along == 0.0 {
            if !(0.0..=far).contains(&at) {
                return None;
            }
            continue;
        }
        let (a, b) = (-at / along, (far - at) / along);
        (first, last) = (first.max(a.min(b)), last.min(a.max(b)));
    }
    (first <= last).then_some((first, last))
}

/// Longest path that a shader is sent on, in texels: whole numbers up to it are exact in f32, with room for a fraction.
const LONGEST: f64 = 65_536.0;

impl Setup {
    /// The part of a ray inside the map's box and a range of t; `None` if there is none. `range` is lowest and highest
    /// height.
    pub(super) fn new(heights: &Heights, [low, high]: [f64; 2], Segment { ray, range }: &Segment) -> Option<Self> {
        let (first, last) = domain(heights, ray, *range)?;
        let (at, along) = (ray.origin[2], ray.direction[2]);
        // A step more than the heights: rounding must not cut off what touches the highest or the lowest.
        let (lid, floor) = ((high + 1.0 - at) / along, (low - 1.0 - at) / along);
        let (first, last) = match along.partial_cmp(&0.0) {
            // Under the lowest height it has met the ground; if it enters the map there, then at once.
            Some(Ordering::Less) => (first.max(lid), last.min(floor.max(first))),
            Some(Ordering::Greater) => (first, last.min(lid)),
            _ if at > high => return None,
            _ => (first, last),
        };
        (first <= last).then(|| Self::between(heights, ray, first, last))
    }

    fn between(heights: &Heights, ray: &Ray, first: f64, last: f64) -> Self {
        let [x, y, z] = ray.direction.map(f64::abs);
        // A vertical ray is parametrised by its height, so that nothing overflows.
        let fastest = x.max(y).max(z / f64::from(1 << 17));
        let scale = if fastest > 0.0 { 1.0 / fastest } else { 1.0 };
        let start = ray.at(first);
        let cell = [0, 1].map(|axis| match heights.border() {
            Border::Wrap => start[axis].floor(),
            // Rounding may place it a little outside; there are no cells there.
            Border::Clamp => start[axis].floor().clamp(0.0, f64::from(heights.cells()[axis] - 1)),
        });
        let inside = [0, 1].map(|axis| (start[axis] - cell[axis]).clamp(0.0, 1.0));
        let end = (last - first) / scale;
        let device = DeviceRay {
            // Modulo 2^32, of which the sides of a map that wraps are divisors.
            cell: cell.map(|cell| cell as i64 as i32),
            origin: [inside[0] as f32, inside[1] as f32, start[2] as f32],
            direction: ray.direction.map(|along| (along * scale) as f32),
            end: end.clamp(0.0, LONGEST) as f32,
            ..DeviceRay::default()
        };
        Self { ray: device, start: first, scale, is_cut: end > LONGEST }
    }

    /// A t of the ray from one of the device's.
    pub(super) fn t(&self, device: f32) -> f64 {
        self.start + self.scale * f64::from(device)
    }
}
