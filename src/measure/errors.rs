//! How far off a method is.

use rayon::prelude::*;
use terrane_shaderlib::heightfield::{Heights, Hit, first_hit};

use super::judge::Judge;
use super::slope::{angle, facing, normal};
use crate::relief::{Outcome, Segment, Traced};

/// Errors over the rays of a view. Distances are in texels along the ray, angles in degrees, over rays that hit and should.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Hits that were not found, per million rays.
    pub missed: f64,
    /// Hits where there is nothing, per million rays.
    pub false_hits: f64,
    /// Rays that were given up, per million.
    pub unresolved: f64,
    /// Distances from the true hits.
    pub distance: Spread,
    /// Right hits that are far from the true ones because rounding decides what the ray meets, per million rays: it passes
    /// something so closely.
    pub decided: f64,
    /// The distances of all other rays that do not graze the surface: |n·d| > 0.01. Where one grazes, a step of height is many
    /// texels.
    pub facing: Spread,
    /// Angles between the normals at the true hit and at the one found.
    pub normal: Spread,
}

/// Numbers in short.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// Their mean.
    pub mean: f64,
    /// One in a hundred is larger.
    pub p99: f64,
    /// One in a thousand is larger.
    pub p999: f64,
    /// The largest.
    pub max: f64,
}

/// A ray that hit and should.
#[derive(Clone, Copy)]
struct Pair {
    distance: f64,
    /// Whether the ray does not graze.
    facing: bool,
    /// Whether rounding decides what it meets.
    decided: bool,
    angle: f64,
}

/// |n·d| from which a ray does not graze.
const GRAZES: f64 = 0.01;

/// The true hits.
pub(super) fn truth(heights: &Heights, rays: &[Segment]) -> Vec<Option<Hit>> {
    rays.par_iter().map(|segment| first_hit(heights, &segment.ray, segment.range)).collect()
}

impl Errors {
    /// Compares outcomes with the true hits. `scale` is texels to a step of height.
    pub(super) fn new(
        heights: &Heights,
        scale: f64,
        rays: &[Segment],
        truth: &[Option<Hit>],
        traced: &[Traced],
    ) -> Self {
        let million = |count: usize| count as f64 * 1e6 / rays.len().max(1) as f64;
        let share = |wrong: &dyn Fn(&Option<Hit>, Outcome) -> bool| {
            million(truth.iter().zip(traced).filter(|(hit, traced)| wrong(hit, traced.outcome)).count())
        };
        let all = rays.par_iter().zip(truth).zip(traced);
        let pairs: Vec<Pair> =
            all.filter_map(|((ray, hit), traced)| pair(heights, scale, ray, hit.as_ref()?, traced)).collect();
        let facing = pairs.iter().filter(|pair| pair.facing && !pair.decided);
        Self {
            missed: share(&|hit, outcome| hit.is_some() && outcome == Outcome::Miss),
            false_hits: share(&|hit, outcome| hit.is_none() && matches!(outcome, Outcome::Hit(_))),
            unresolved: share(&|_, outcome| outcome == Outcome::Unresolved),
            distance: Spread::of(pairs.iter().map(|pair| pair.distance)),
            decided: million(pairs.iter().filter(|pair| pair.decided).count()),
            facing: Spread::of(facing.map(|pair| pair.distance)),
            normal: Spread::of(pairs.iter().map(|pair| pair.angle)),
        }
    }

    /// Whether every ray was decided, and rightly.
    #[must_use]
    pub fn is_decided(&self) -> bool {
        self.missed == 0.0 && self.false_hits == 0.0 && self.unresolved == 0.0
    }
}

impl Spread {
    /// Of none it is 0.
    fn of(numbers: impl Iterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = numbers.collect();
        sorted.par_sort_unstable_by(f64::total_cmp);
        let rank = |share: f64| sorted.get((share * sorted.len() as f64) as usize).or(sorted.last());
        let at = |share: f64| rank(share).copied().unwrap_or(0.0);
        let mean = sorted.iter().sum::<f64>() / sorted.len().max(1) as f64;
        Self { mean, p99: at(0.99), p999: at(0.999), max: at(1.0) }
    }
}

fn pair(heights: &Heights, scale: f64, segment: &Segment, hit: &Hit, traced: &Traced) -> Option<Pair> {
    let Outcome::Hit(t) = traced.outcome else { return None };
    let [x, y, _] = segment.ray.direction;
    let there = normal(heights, scale, hit.cell, hit.uv);
    let [u, v, _] = segment.ray.at(t);
    let (cell, uv) = place([u, v], hit.cell);
    let distance = (t - hit.t).abs() * x.hypot(y);
    let facing = facing(there, scale, segment.ray.direction) > GRAZES;
    Some(Pair {
        distance,
        facing,
        decided: facing && Judge::knowing(heights, *segment, Some(*hit)).is_excused(traced, distance),
        angle: angle(there, normal(heights, scale, cell, uv)),
    })
}

/// The cell of a point, and where in it. On a border two cells are right: then it is the one that is expected.
fn place(at: [f64; 2], expected: [i64; 2]) -> ([i64; 2], [f64; 2]) {
    /// Texels that rounding moves a hit by.
    const ROUNDING: f64 = 1e-3;
    let within = |cell: [i64; 2]| [0, 1].map(|axis| at[axis] - cell[axis] as f64);
    let near = within(expected).iter().all(|part| (-ROUNDING..=1.0 + ROUNDING).contains(part));
    let cell = if near { expected } else { at.map(|at| at.floor() as i64) };
    (cell, within(cell).map(|part| part.clamp(0.0, 1.0)))
}

#[cfg(test)]
mod tests {
    use terrane_shaderlib::heightfield::{Border, Ray, Texels};

    use super::*;

    /// A plane that rises by 2 steps a texel along x, and rays that come down on it at 45°.
    fn slope() -> (Heights, Vec<Segment>, Vec<Option<Hit>>) {
        let texels = (0..64).map(|index| 2 * (index % 8)).collect();
        let heights = Heights::new([8, 8], Border::Clamp, Texels::U16(texels)).unwrap();
        let ray = |y: f64| Ray { origin: [0.25, y, 10.0], direction: [1.0, 0.0, -1.0] };
        let rays: Vec<Segment> = [1.5, 2.5, 3.5, 4.5].map(|y| Segment { ray: ray(y), range: (0.0, 100.0) }).into();
        let truth = truth(&heights, &rays);
        (heights, rays, truth)
    }

    fn traced(outcome: Outcome) -> Traced {
        Traced { outcome, cell: [0; 2], steps: 1, leaves: 1 }
    }

    #[test]
    fn each_kind_of_error_is_counted() {
        let (heights, rays, mut truth) = slope();
        let t = truth[0].unwrap().t;
        truth[3] = None;
        let traced = [Outcome::Hit(t + 0.5), Outcome::Miss, Outcome::Unresolved, Outcome::Hit(t)].map(traced);
        let errors = Errors::new(&heights, 0.5, &rays, &truth, &traced);
        assert_eq!([errors.missed, errors.false_hits, errors.unresolved], [250_000.0; 3]);
        assert!((errors.distance.max - 0.5).abs() < 1e-12, "{errors:?}");
        assert!(!errors.is_decided());
        // A plane has one normal.
        assert!(errors.normal.max < 1e-6, "{errors:?}");
    }

    #[test]
    fn spreads_rank_their_numbers() {
        let spread = Spread::of((0..1000).map(f64::from));
        assert_eq!(spread, Spread { mean: 499.5, p99: 990.0, p999: 999.0, max: 999.0 });
        assert_eq!(Spread::of(std::iter::empty()), Spread::default());
    }

    #[test]
    fn rays_that_graze_stand_apart() {
        let (heights, rays, truth) = slope();
        // 2 steps a texel of 0.5 texels each rise by 45°, and so does a ray of 1 texel to 2 steps: along the plane.
        let along = Segment { ray: Ray { origin: [0.0, 1.0, 0.05], direction: [1.0, 0.0, 1.99] }, range: (0.0, 100.0) };
        let grazing = first_hit(&heights, &along.ray, along.range);
        assert!(grazing.is_some());
        let all = [&rays[..1], &[along]].concat();
        let truth = [truth[0], grazing];
        let far = |hit: Option<Hit>, off: f64| traced(Outcome::Hit(hit.unwrap().t + off));
        let errors = Errors::new(&heights, 0.5, &all, &truth, &[far(truth[0], 0.25), far(truth[1], 3.0)]);
        assert!((errors.facing.max - 0.25).abs() < 1e-9 && (errors.distance.max - 3.0).abs() < 1e-9, "{errors:?}");
    }

    #[test]
    fn rays_of_which_rounding_decides_stand_apart() {
        // A ridge 1000 steps high across x = 4, over flat ground; a ray along x that passes its top by 2^-10 of a step.
        let texels = (0..64).map(|index| if index % 8 == 4 { 1000 } else { 0 }).collect();
        let heights = Heights::new([8, 8], Border::Wrap, Texels::U16(texels)).unwrap();
        let ray = Ray { origin: [0.5, 1.5, 1000.0 + 1.0 / 1024.0], direction: [1.0, 0.0, -1.0 / 4096.0] };
        let rays = [Segment { ray, range: (0.0, 1000.0) }];
        let truth = truth(&heights, &rays);
        assert!(truth[0].unwrap().t > 4.0, "it passes the first ridge");
        let errors = |t: f64| Errors::new(&heights, 0.01, &rays, &truth, &[traced(Outcome::Hit(t))]);
        let (first, between) = (errors(3.5), errors(2.0));
        assert!(first.decided > 0.0 && first.facing.max == 0.0, "{first:?}");
        assert!(between.decided == 0.0 && between.facing.max > 1.0, "{between:?}");
    }
}
