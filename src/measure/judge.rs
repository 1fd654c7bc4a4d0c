//! Whether the outcome of an exact method is right, and how far off it is.

use terrane_shaderlib::heightfield::{Heights, Hit, Ray, Texels, first_hit};

use crate::relief::{Outcome, Segment, Traced};

/// Texels of path by which a hit may be off besides what a step of height makes.
const TEXELS: f64 = 1e-3;
/// How deep the relief is taken to be where angles are measured, over the length of the map's first side.
const DEPTH: f64 = 0.05;
/// Texels that nobody asks about: to ask costs eight more rays.
const NEAR: f64 = 5e-4;
/// Where a ray that may run beside another is looked for, over how far off it may be: what is far may meet other ground than
/// what is near.
const BESIDE: [f64; 9] = [0.0, 1.0, -1.0, 0.25, -0.25, 0.0625, -0.0625, 0.015_625, -0.015_625];
/// Cosine between ray and normal below which a ray grazes: there a step of height is many texels of path.
const GRAZES: f64 = 0.01;

/// What is wrong with an outcome.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The search was given up.
    Unresolved,
    /// The ray passes the ground.
    Missed,
    /// The hit lies before any ground.
    Early,
    /// The hit lies behind the first ground.
    Late,
}

/// The truth about one ray.
#[derive(Clone, Copy, Debug)]
pub struct Judge<'a> {
    heights: &'a Heights,
    segment: Segment,
    /// The first hit of the reference.
    pub truth: Option<Hit>,
}

impl<'a> Judge<'a> {
    /// Asks the reference.
    #[must_use]
    pub fn new(heights: &'a Heights, segment: Segment) -> Self {
        Self::knowing(heights, segment, first_hit(heights, &segment.ray, segment.range))
    }

    /// Of a ray whose first hit is known.
    pub(super) fn knowing(heights: &'a Heights, segment: Segment, truth: Option<Hit>) -> Self {
        Self { heights, segment, truth }
    }

    /// What is wrong with an outcome, if anything: it must lie between the first hits of the ray 2^-16 of the depth lower and as
    /// much higher.
    #[must_use]
    pub fn fault(&self, traced: &Traced) -> Option<Fault> {
        let slack = self.slack();
        match (traced.outcome, self.truth) {
            // Whatever is near the true hit lies between the two, and needs no more rays.
            (Outcome::Hit(t), Some(hit)) if (t - hit.t).abs() <= slack => None,
            (Outcome::Miss, None) => None,
            _ => self.fault_beside(traced, 0.0),
        }
    }

    /// Whether a fault is none of a ray that runs beside this one by no more than positions in f32 lack after its path, which
    /// docs/relief/proof.md derives: that is all that a shader can be asked for along walls.
    #[must_use]
    pub fn is_beside(&self, traced: &Traced) -> bool {
        let t = if let Outcome::Hit(t) = traced.outcome { t } else { self.segment.range.1 };
        self.fault_beside(traced, self.lacking(t)).is_none()
    }

    /// As [`Self::fault`], but the ray may run up to so many texels to the left or to the right.
    fn fault_beside(&self, traced: &Traced, texels: f64) -> Option<Fault> {
        let (slack, step) = (self.slack(), step(self.heights));
        let sides = if texels > 0.0 { &BESIDE[..] } else { &BESIDE[..1] };
        let hits = |steps: f64| sides.iter().map(move |side| self.first_hit(side * texels, steps).map(|hit| hit.t));
        let lower = hits(-step).flatten().reduce(f64::min);
        let higher = hits(step).reduce(|a, b| a.zip(b).map(|(a, b)| a.max(b))).flatten();
        match traced.outcome {
            Outcome::Unresolved => Some(Fault::Unresolved),
            Outcome::Miss => higher.is_some_and(|t| t < self.segment.range.1 - slack).then_some(Fault::Missed),
            Outcome::Hit(t) if lower.is_none_or(|lower| t < lower - slack) => Some(Fault::Early),
            Outcome::Hit(t) if higher.is_some_and(|higher| t > higher + slack) => Some(Fault::Late),
            Outcome::Hit(_) => None,
        }
    }

    /// Texels between a hit and the true one, where there are both and the ray does not graze the ground.
    #[must_use]
    pub fn distance(&self, traced: &Traced) -> Option<f64> {
        let (Some(hit), Outcome::Hit(t)) = (self.truth, traced.outcome) else { return None };
        let texels = texels_a_step(self.heights);
        let [x, y, z] = self.segment.ray.direction;
        let along = [x, y, z * texels];
        let [a, b, c, d] = self.heights.corners(hit.cell[0], hit.cell[1]);
        let [u, v] = hit.uv;
        let slopes = [(b - a) * (1.0 - v) + (d - c) * v, (c - a) * (1.0 - u) + (d - b) * u];
        let normal = [-slopes[0] * texels, -slopes[1] * texels, 1.0];
        let dot: f64 = (0..3).map(|axis| along[axis] * normal[axis]).sum();
        let cosine = dot.abs() / (length(along) * length(normal));
        (cosine > GRAZES).then(|| (t - hit.t).abs() * length(along))
    }

    /// Whether a hit so many texels from the true one is right all the same, since rounding decides what the ray meets.
    #[must_use]
    pub fn is_excused(&self, traced: &Traced, distance: f64) -> bool {
        let (Some(hit), Outcome::Hit(t)) = (self.truth, traced.outcome) else { return false };
        if distance <= NEAR || self.fault(traced).is_some() {
            return false;
        }
        let (moved, slack) = (self.moved_by_rounding(t), self.slack());
        moved > slack && (t - hit.t).abs() <= moved + slack
    }

    /// Whether rounding decides what the ray meets. Then no place is the right one, but those between.
    #[must_use]
    pub fn is_decided_by_rounding(&self) -> bool {
        self.moved_by_rounding(self.segment.range.0) > self.slack()
    }

    /// How much t of the first hit changes at most where the ray runs as much higher, lower or beside as f32 rounds after its path
    /// to the hit or to t = `found`, if that is later: it may meet the ground elsewhere, or not at all.
    fn moved_by_rounding(&self, found: f64) -> f64 {
        let (last, up) = (self.segment.range.1, step(self.heights) / 64.0);
        let plain = self.truth.map_or(last, |hit| hit.t);
        let beside = self.lacking(plain.max(found));
        let sides = [0.0, beside, -beside].into_iter().flat_map(|left| [0.0, up, -up].map(|up| (left, up)));
        let hits = sides.skip(1).map(|(left, up)| self.first_hit(left, up).map_or(last, |hit| hit.t));
        hits.map(|t| (t - plain).abs()).fold(0.0, f64::max)
    }

    /// Texels that positions in f32 lack at t.
    fn lacking(&self, t: f64) -> f64 {
        (7.0 * (t - self.segment.range.0) * self.fastest() + 13.0) / 16_777_216.0
    }

    /// All there is to know, for a report.
    #[must_use]
    pub fn describe(&self, traced: &Traced) -> String {
        let step = step(self.heights);
        let (lower, higher) = (self.first_hit(0.0, -step), self.first_hit(0.0, step));
        let (size, border) = (self.heights.size(), self.heights.border());
        let Segment { ray, range } = self.segment;
        format!("{traced:?}, lower {lower:?}, higher {higher:?}, {ray:?} {range:?}, {size:?} {border:?}")
    }

    /// The first hit of the ray, so many texels to the left and so many steps higher.
    fn first_hit(&self, left: f64, steps: f64) -> Option<Hit> {
        let Segment { ray, range } = self.segment;
        let ([x, y, z], [dx, dy, _]) = (ray.origin, ray.direction);
        let unit = left / dx.hypot(dy).max(f64::MIN_POSITIVE);
        first_hit(self.heights, &Ray { origin: [x - unit * dy, y + unit * dx, z + steps], ..ray }, range)
    }

    /// Texels on the ray's faster axis for 1 of t; for a vertical ray 2^-17 of its steps.
    #[must_use]
    pub fn fastest(&self) -> f64 {
        let [x, y, z] = self.segment.ray.direction.map(f64::abs);
        x.max(y).max(z / 131_072.0)
    }

    fn slack(&self) -> f64 {
        TEXELS / self.fastest().max(f64::MIN_POSITIVE)
    }
}

fn length([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

/// Steps of height in 2^-16 of the depth.
fn step(heights: &Heights) -> f64 {
    full(heights) / 65536.0
}

fn full(heights: &Heights) -> f64 {
    match heights.texels() {
        Texels::U8(_) => 256.0,
        Texels::U16(_) => 65536.0,
        Texels::F32(values) => values.iter().fold(0.0, |full, value| f64::max(full, f64::from(value.abs()))),
    }
}

fn texels_a_step(heights: &Heights) -> f64 {
    DEPTH * f64::from(heights.size()[0]) / full(heights)
}
