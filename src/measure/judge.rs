//! Whether the outcome of an exact method is right, and how far off it is.

use terrane_shaderlib::heightfield::{Heights, Hit, Ray, Texels, first_hit};

use crate::relief::{Outcome, Segment, Traced};

/// Texels of path by which a hit may be off besides what a step of height makes.
const TEXELS: f64 = 1e-3;
/// How deep the relief is taken to be where angles are measured, over the length of the map's first side.
const DEPTH: f64 = 0.05;
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
        Self { heights, segment, truth: first_hit(heights, &segment.ray, segment.range) }
    }

    /// What is wrong with an outcome, if anything: it must lie between the first hits of the ray 2^-16 of the depth lower and as
    /// much higher.
    #[must_use]
    pub fn fault(&self, traced: &Traced) -> Option<Fault> {
        let slack = self.slack();
        // Whatever is near the true hit lies between the two, and needs no more rays.
        match (traced.outcome, self.truth) {
            (Outcome::Hit(t), Some(hit)) if (t - hit.t).abs() <= slack => return None,
            (Outcome::Miss, None) => return None,
            _ => {}
        }
        let step = step(self.heights);
        let (lower, higher) = (self.first_hit(-step), self.first_hit(step));
        match traced.outcome {
            Outcome::Unresolved => Some(Fault::Unresolved),
            Outcome::Miss => higher.is_some_and(|hit| hit.t < self.segment.range.1 - slack).then_some(Fault::Missed),
            Outcome::Hit(t) if lower.is_none_or(|hit| t < hit.t - slack) => Some(Fault::Early),
            Outcome::Hit(t) if higher.is_some_and(|hit| t > hit.t + slack) => Some(Fault::Late),
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

    /// All there is to know, for a report.
    #[must_use]
    pub fn describe(&self, traced: &Traced) -> String {
        let step = step(self.heights);
        let (lower, higher) = (self.first_hit(-step), self.first_hit(step));
        let (size, border) = (self.heights.size(), self.heights.border());
        let Segment { ray, range } = self.segment;
        format!("{traced:?}, lower {lower:?}, higher {higher:?}, {ray:?} {range:?}, {size:?} {border:?}")
    }

    /// The first hit of the ray, so many steps higher.
    fn first_hit(&self, steps: f64) -> Option<Hit> {
        let Segment { ray, range } = self.segment;
        let [x, y, z] = ray.origin;
        first_hit(self.heights, &Ray { origin: [x, y, z + steps], ..ray }, range)
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
