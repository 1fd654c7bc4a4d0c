//! Rays that methods fail on.

use super::random::Random;
use crate::heightfield::{Border, FixedRay, Heights, Ray, Texels};

/// One ray, as a tracer gets it and as the oracle does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// For the tracer.
    pub ray: Ray,
    /// The same ray exactly; but components below 10^−199 are 0.
    pub fixed: FixedRay,
    /// The range of t is from 0 to this.
    pub end: i64,
}

/// An endless source of rays for one map.
#[derive(Clone, Debug)]
pub struct Rays<'a> {
    pub(super) heights: &'a Heights,
    pub(super) random: Random,
    /// The highest number that a texel of the map can have, and the highest that one has, with where it stands.
    pub(super) range: i64,
    pub(super) tip: [i64; 3],
}

impl<'a> Rays<'a> {
    /// The same rays from the same map and seed.
    #[must_use]
    pub fn new(heights: &'a Heights, seed: u64) -> Self {
        let columns = i64::from(heights.size()[0]);
        let (place, top) = highest(heights.texels());
        let range = if matches!(heights.texels(), Texels::U8(_)) { 255 } else { 65535 };
        Self { heights, random: Random::new(seed), range, tip: [place % columns, place / columns, top] }
    }

    /// A ray from above the highest texel, in any direction, at an elevation of which this is the tangent. The map is
    /// as high as a twentieth to a half of its longer side.
    pub fn above(&mut self, tangent: f64) -> Case {
        let [x, y] = self.anywhere();
        let z = self.tip[2] * 256 + self.random.between(0, 512);
        let [dx, dy] = self.azimuth();
        let side = f64::from(self.heights.size()[0].max(self.heights.size()[1]));
        let steps = self.range as f64 * self.random.one_of(&[2.0, 5.0, 20.0]) / side;
        let length = f64::from(dx * dx + dy * dy).sqrt();
        let fall = (length * tangent * steps).ceil().min(f64::from(1 << 24)) as i32;
        self.from([x, y, z], [dx, dy, -fall])
    }

    /// A ray from a point, until it has crossed the map about twice. All of it in 1/256.
    pub(super) fn from(&self, point: [i64; 3], direction: [i32; 3]) -> Case {
        let [width, height] = self.heights.size().map(i64::from);
        let away = match self.heights.border() {
            Border::Wrap => 0,
            Border::Clamp => point[0].abs().max(point[1].abs()),
        };
        let way = (2 * (width + height) + 8) * 256 + away;
        let end = match (fastest(direction), i64::from(direction[2]).abs()) {
            (0, 0) => 1,
            (0, fall) => (point[2].abs() + self.range * 256) / fall + 1,
            (rate, _) => way / rate + 1,
        };
        let fixed = FixedRay { origin: point, direction };
        Case { ray: Ray::from(fixed), fixed, end }
    }

    /// A ray through a point, from up to 24 texels before it.
    pub(super) fn through(&mut self, point: [i64; 3], direction: [i32; 3]) -> Case {
        let before = match fastest(direction) {
            0 => self.random.between(0, 4),
            rate => self.random.between(0, 24 * 256 / rate),
        };
        self.since(point, direction, before)
    }

    /// A ray through a point, so many t before it.
    pub(super) fn since(&self, point: [i64; 3], direction: [i32; 3], before: i64) -> Case {
        let origin = [0, 1, 2].map(|axis| point[axis] - before * i64::from(direction[axis]));
        let case = self.from(origin, direction);
        Case { end: case.end + before, ..case }
    }

    /// Three tiles wide around the map; a clamped map has nothing there, but rays may come from it.
    fn anywhere(&mut self) -> [i64; 2] {
        self.heights.size().map(|side| self.random.between(-256 * i64::from(side), 512 * i64::from(side)))
    }

    /// A direction in a disc of 4 texels, not so short that its own rounding shows.
    pub(super) fn azimuth(&mut self) -> [i32; 2] {
        loop {
            let [x, y] = [(); 2].map(|()| self.random.between(-1024, 1024) as i32);
            if (256..=1 << 20).contains(&(x * x + y * y)) {
                return [x, y];
            }
        }
    }
}

fn fastest(direction: [i32; 3]) -> i64 {
    i64::from(direction[0].abs().max(direction[1].abs()))
}

/// The first of the highest texels, and its height in whole steps.
fn highest(texels: &Texels) -> (i64, i64) {
    let heights: Vec<i64> = match texels {
        Texels::U8(values) => values.iter().map(|value| i64::from(*value)).collect(),
        Texels::U16(values) => values.iter().map(|value| i64::from(*value)).collect(),
        Texels::F32(values) => values.iter().map(|value| value.ceil() as i64).collect(),
    };
    let highest = heights.into_iter().enumerate().max_by_key(|(at, height)| (*height, -(*at as i64)));
    highest.map_or((0, 0), |(at, height)| (at as i64, height))
}
