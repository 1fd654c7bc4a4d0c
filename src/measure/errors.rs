//! How far off a method is.

use rayon::prelude::*;
use terrane_shaderlib::heightfield::{Heights, Hit, first_hit};

use crate::relief::{Outcome, Segment, Traced};

/// Errors over the rays of a view. Distances are in texels along the ray, over rays that hit and should.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Hits that were not found, per million rays.
    pub missed: f64,
    /// Hits where there is nothing, per million rays.
    pub false_hits: f64,
    /// Rays that were given up, per million.
    pub unresolved: f64,
    /// Mean distance from the true hit.
    pub mean: f64,
    /// Distance that one ray in a hundred exceeds.
    pub p99: f64,
    /// Distance that one ray in a thousand exceeds.
    pub p999: f64,
    /// Largest distance.
    pub max: f64,
}

/// The true hits.
pub(super) fn truth(heights: &Heights, rays: &[Segment]) -> Vec<Option<Hit>> {
    rays.par_iter().map(|segment| first_hit(heights, &segment.ray, segment.range)).collect()
}

impl Errors {
    /// Compares outcomes with the true hits.
    pub(super) fn new(rays: &[Segment], truth: &[Option<Hit>], traced: &[Traced]) -> Self {
        let share = |wrong: &dyn Fn(&Option<Hit>, Outcome) -> bool| {
            let count = truth.iter().zip(traced).filter(|(hit, traced)| wrong(hit, traced.outcome)).count();
            count as f64 * 1e6 / rays.len() as f64
        };
        let mut distances: Vec<f64> = rays.iter().zip(truth).zip(traced).filter_map(distance).collect();
        distances.sort_by(f64::total_cmp);
        let rank = |share: f64| distances.get((share * distances.len() as f64) as usize).or(distances.last());
        let at = |share: f64| rank(share).copied().unwrap_or(0.0);
        Self {
            missed: share(&|hit, outcome| hit.is_some() && outcome == Outcome::Miss),
            false_hits: share(&|hit, outcome| hit.is_none() && matches!(outcome, Outcome::Hit(_))),
            unresolved: share(&|_, outcome| outcome == Outcome::Unresolved),
            mean: distances.iter().sum::<f64>() / distances.len().max(1) as f64,
            p99: at(0.99),
            p999: at(0.999),
            max: at(1.0),
        }
    }
}

fn distance(((segment, hit), traced): ((&Segment, &Option<Hit>), &Traced)) -> Option<f64> {
    let (Some(hit), Outcome::Hit(t)) = (hit, traced.outcome) else { return None };
    let [x, y, _] = segment.ray.direction;
    Some((t - hit.t).abs() * x.hypot(y))
}
