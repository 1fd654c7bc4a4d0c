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

/// `ReliefRay` of shaderlib/wgsl/relief/relief.wgsl in two texels of four words.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DeviceRay {
    /// Where in its first cell it starts, 0..1; z in steps.
    pub origin: [f32; 3],
    /// That cell, in the first tile of a map that wraps: the column, and above it the row.
    pub cell: [u16; 2],
    /// How far 1 of t leads.
    pub direction: [f32; 3],
    /// The ray is looked at for t in 0..end.
    pub end: f32,
}

/// A ray ready for the device, and the way back.
#[derive(Clone, Copy, Debug, Default)]
pub struct Setup {
    /// What the device gets.
    pub ray: DeviceRay,
    /// t of the ray where that of the device is 0.
    start: f64,
    /// t of the ray for 1 of the device's.
    scale: f64,
    /// Whether the device's ray ends before that which it stands for: then a miss decides nothing.
    pub is_cut: bool,
    /// What the device's cells lack of the ray's: whole tiles of a map that wraps.
    corner: [i64; 2],
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

/// One coordinate of a ray's start.
#[derive(Clone, Copy)]
struct Place {
    /// The cell, in the first tile of a map that wraps.
    cell: i32,
    /// Where in it, 0..1.
    inside: f64,
    /// What the cell lacks: whole tiles.
    corner: i64,
}

impl Place {
    /// At t. The whole texels of the origin stay apart from its fraction: a million tiles away not a bit is lost.
    fn new(heights: &Heights, ray: &Ray, axis: usize, t: f64) -> Self {
        let (whole, side) = (ray.origin[axis].floor(), i64::from(heights.cells()[axis]));
        let way = t.mul_add(ray.direction[axis], ray.origin[axis] - whole);
        // Positions beyond 2^53 have no cell; no map is traced there.
        let cell = (whole as i64).saturating_add(way.floor() as i64);
        let inside = way - way.floor();
        match heights.border() {
            Border::Wrap => {
                let wrapped = cell.rem_euclid(side);
                Self { cell: wrapped as i32, inside, corner: cell - wrapped }
            }
            // Rounding may place it a little outside; there are no cells there.
            Border::Clamp => {
                let held = cell.clamp(0, side - 1);
                let inside = (inside + (cell - held) as f64).clamp(0.0, 1.0);
                Self { cell: held as i32, inside, corner: 0 }
            }
        }
    }
}

/// Longest path that a shader is sent on, in texels: whole numbers up to it are exact in f32, with room for a fraction.
pub(super) const LONGEST: f64 = 65_536.0;

impl Setup {
    /// The part of a ray inside the map's box and a range of t; `None` if there is none. `range` is lowest and highest
    /// height.
    #[must_use]
    pub fn new(heights: &Heights, [low, high]: [f64; 2], Segment { ray, range }: &Segment) -> Option<Self> {
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

    /// Where a ray begins, and its direction.
    pub(super) fn at(heights: &Heights, ray: &Ray) -> Self {
        Self::between(heights, ray, 0.0, 0.0)
    }

    fn between(heights: &Heights, ray: &Ray, first: f64, last: f64) -> Self {
        let [x, y, z] = ray.direction.map(f64::abs);
        // A vertical ray is parametrised by its height, so that nothing overflows.
        let fastest = x.max(y).max(z / f64::from(1 << 17));
        // One that stands still, or is so slow that the inverse overflows, has no direction: all of it is its start.
        let scale = Some(1.0 / fastest).filter(|scale| scale.is_finite()).unwrap_or(1.0);
        let places = [0, 1].map(|axis| Place::new(heights, ray, axis, first));
        let end = (last - first) / scale;
        let device = DeviceRay {
            // No map is longer than u16 counts.
            cell: places.map(|place| place.cell as u16),
            origin: [places[0].inside as f32, places[1].inside as f32, ray.at(first)[2] as f32],
            direction: ray.direction.map(|along| (along * scale) as f32),
            end: end.clamp(0.0, LONGEST) as f32,
        };
        Self { ray: device, start: first, scale, is_cut: end > LONGEST, corner: places.map(|place| place.corner) }
    }

    /// A t of the ray from one of the device's.
    #[must_use]
    pub fn t(&self, device: f32) -> f64 {
        self.start + self.scale * f64::from(device)
    }

    /// A cell of the ray from one of the device's: beyond the first tile it goes on counting.
    #[must_use]
    pub fn cell(&self, device: [i32; 2]) -> [i64; 2] {
        [0, 1].map(|axis| self.corner[axis] + i64::from(device[axis]))
    }
}
