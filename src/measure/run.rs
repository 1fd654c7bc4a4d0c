//! Every method over every view of a map.

use std::collections::{BTreeMap, BTreeSet};

use terrane_shaderlib::heightfield::Hit;
use terrane_shaderlib::relief::{Bounds, Method, Placed, Unplaceable};

use super::errors::{Errors, truth};
use super::row::Row;
use super::subject::Subject;
use super::times::Times;
use super::view::View;
use crate::relief::{Segment, Timing, Traced, Tracer};
use crate::render::{Gpu, Phase, Progress, RenderError};

/// What is measured.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The methods; the baseline is measured besides.
    pub methods: Vec<Method>,
    /// Degrees above the ground.
    pub elevations: Vec<f64>,
    /// How deep the relief is, over the side of the tile.
    pub depths: Vec<f64>,
    /// Columns and rows of rays.
    pub size: [u32; 2],
    /// Times that each is traced; their median counts.
    pub rounds: u32,
    /// Nodes after which a search is given up.
    pub limit: u32,
}

/// What every time is compared with: the exact method as it was published.
pub const BASELINE: Method = Method::MaximumMipmaps;

impl Plan {
    /// The methods with the baseline, which comes first where it was not named.
    fn methods(&self) -> Vec<Method> {
        let missing = (!self.methods.contains(&BASELINE)).then_some(BASELINE);
        missing.into_iter().chain(self.methods.iter().copied()).collect()
    }

    fn views(&self) -> Vec<View> {
        let pairs =
            self.depths.iter().flat_map(|depth| self.elevations.iter().map(move |elevation| (depth, elevation)));
        pairs.map(|(&depth, &elevation)| View { elevation, depth, size: self.size }).collect()
    }

    /// How often each is traced: the first round does not count, since a driver may compile in it.
    fn traces(&self) -> u32 {
        self.rounds.max(1) + 1
    }
}

/// Traces every view of a map by every method, in turns, so that what else the machine does hits all alike.
///
/// # Errors
/// Where the map cannot be placed on the device, or the device fails.
pub fn measure(gpu: &Gpu, subject: &Subject, plan: &Plan, progress: Progress) -> Result<Vec<Row>, RenderError> {
    let methods = plan.methods();
    let placed = placed(subject, &methods, plan.limit).map_err(|error| RenderError::Scene(error.to_string()))?;
    let tracers = tracers(gpu, subject, &methods, &placed)?;
    let views = plan.views();
    let phase = progress.phase("measuring", views.len() as u64 * (u64::from(plan.traces()) + 1));
    let mut rows = Vec::new();
    for view in &views {
        let rays = view.rays(&subject.heights, subject.full);
        let truth = truth(&subject.heights, &rays);
        phase.advance(1);
        let (times, traced) = rounds(&tracers, &rays, plan.traces(), &phase)?;
        let one = Scene { subject, view, rays: &rays, truth: &truth, timing: Timing::of(gpu) };
        rows.extend(methods.iter().enumerate().map(|(index, method)| {
            let times =
                [times.median(index), times.ratio(index, BASELINE, &methods), times.over_exact(index, &methods)];
            one.row(*method, times, &traced[index])
        }));
    }
    Ok(rows)
}

/// The map with the bounds of every method.
fn placed(subject: &Subject, methods: &[Method], limit: u32) -> Result<BTreeMap<Bounds, Placed>, Unplaceable> {
    let bounds: BTreeSet<Bounds> = methods.iter().map(|method| method.bounds()).collect();
    bounds.into_iter().map(|one| Ok((one, Placed::new(&subject.heights, one, limit)?))).collect()
}

/// One for each method; those with the same bounds share what is uploaded.
fn tracers<'a>(
    gpu: &'a Gpu,
    subject: &'a Subject,
    methods: &[Method],
    placed: &BTreeMap<Bounds, Placed>,
) -> Result<Vec<Tracer<'a>>, RenderError> {
    let mut tracers: Vec<Tracer<'a>> = Vec::new();
    for (index, method) in methods.iter().enumerate() {
        let same = methods[..index].iter().position(|earlier| earlier.bounds() == method.bounds());
        tracers.push(match same {
            Some(earlier) => tracers[earlier].sharing(*method)?,
            None => Tracer::new(gpu, &subject.heights, &placed[&method.bounds()], *method)?,
        });
    }
    Ok(tracers)
}

/// Nanoseconds a ray of every counted round, and what the first one found.
fn rounds(
    tracers: &[Tracer<'_>],
    rays: &[Segment],
    traces: u32,
    phase: &Phase,
) -> Result<(Times, Vec<Vec<Traced>>), RenderError> {
    let mut times = Times::new(tracers.len());
    let mut traced = Vec::new();
    let Some(sent) = tracers.first().map(|tracer| tracer.send(rays)).transpose()? else { return Ok((times, traced)) };
    for tracer in tracers {
        traced.push(tracer.find(&sent)?);
        tracer.time(&sent)?;
    }
    phase.advance(1);
    for _ in 1..traces {
        for (index, tracer) in tracers.iter().enumerate() {
            times.add(index, tracer.time(&sent)?.as_secs_f64() * 1e9 / rays.len().max(1) as f64);
        }
        phase.advance(1);
    }
    Ok((times, traced))
}

/// What all rows of a view have in common.
struct Scene<'a> {
    subject: &'a Subject,
    view: &'a View,
    rays: &'a [Segment],
    truth: &'a [Option<Hit>],
    timing: Timing,
}

impl Scene<'_> {
    fn row(&self, method: Method, [time, ratio, over_exact]: [f64; 3], traced: &[Traced]) -> Row {
        let Self { subject, view, rays, truth, timing } = *self;
        let scale = view.scale(&subject.heights, subject.full);
        let leaves = traced.iter().map(|one| f64::from(one.leaves)).sum::<f64>();
        Row {
            map: subject.name.clone(),
            side: subject.heights.size()[0],
            depth: view.depth,
            elevation: view.elevation,
            method,
            timing,
            time,
            ratio,
            over_exact,
            steps: spread(traced),
            leaves: leaves / rays.len().max(1) as f64,
            errors: Errors::new(&subject.heights, scale, rays, truth, traced),
        }
    }
}

fn spread(traced: &[Traced]) -> [f64; 3] {
    let mut steps: Vec<u32> = traced.iter().map(|one| one.steps).collect();
    steps.sort_unstable();
    let mean = steps.iter().map(|steps| f64::from(*steps)).sum::<f64>() / steps.len().max(1) as f64;
    let at = |index: usize| steps.get(index).copied().map_or(0.0, f64::from);
    [mean, at(steps.len() * 99 / 100), at(steps.len().saturating_sub(1))]
}
