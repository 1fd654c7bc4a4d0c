//! Every method over every view of a map.

use std::collections::{BTreeMap, BTreeSet};

use terrane_shaderlib::relief::{Bounds, Method, Placed, Unplaceable};

use crate::relief::{Traced, Tracer};
use crate::render::{Gpu, Progress, RenderError};

use super::errors::{Errors, truth};
use super::subject::Subject;
use super::view::View;

/// What is measured.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The first is what the times of the others are compared with.
    pub methods: Vec<Method>,
    /// Degrees above the ground.
    pub elevations: Vec<f64>,
    /// How deep the relief is, over the side of the tile.
    pub depth: f64,
    /// Columns and rows of rays.
    pub size: [u32; 2],
    /// Times that each is traced; their median counts.
    pub rounds: u32,
    /// Nodes after which a search is given up.
    pub limit: u32,
}

/// One method over one view.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The map.
    pub map: String,
    /// Its texels a side.
    pub side: u32,
    /// Degrees above the ground.
    pub elevation: f64,
    /// The method.
    pub method: Method,
    /// Nodes or samples a ray: mean, what one in a hundred exceeds, most.
    pub steps: [f64; 3],
    /// Patches intersected, a ray.
    pub leaves: f64,
    /// Nanoseconds a ray, all cores together.
    pub time: f64,
    /// Time over that of the first method, in the same rounds.
    pub ratio: f64,
    /// Against the reference.
    pub errors: Errors,
}

/// Traces every view of a map by every method, in turns, so that what else the machine does hits all alike.
///
/// # Errors
/// Where the map cannot be placed on the device, or the device fails.
pub fn measure(gpu: &Gpu, subject: &Subject, plan: &Plan, progress: Progress) -> Result<Vec<Row>, RenderError> {
    let placed = placed(subject, plan).map_err(|error| RenderError::Scene(error.to_string()))?;
    let tracer = |method: &Method| Tracer::new(gpu, &subject.heights, &placed[&method.bounds()], *method);
    let tracers = plan.methods.iter().map(tracer);
    let tracers = tracers.collect::<Result<Vec<_>, _>>()?;
    let phase = progress.phase("measuring", plan.elevations.len() as u64 * (u64::from(plan.rounds.max(1)) + 2));
    let mut rows = Vec::new();
    for &elevation in &plan.elevations {
        let view = View { elevation, depth: plan.depth, size: plan.size };
        let rays = view.rays(&subject.heights, subject.full);
        let truth = truth(&subject.heights, &rays);
        phase.advance(1);
        let mut times = vec![Vec::new(); tracers.len()];
        let mut traced = vec![Vec::new(); tracers.len()];
        for round in 0..=plan.rounds.max(1) {
            for (index, tracer) in tracers.iter().enumerate() {
                let (found, time) = tracer.trace(&rays)?;
                // A driver may compile in the first round.
                if round > 0 {
                    times[index].push(time.as_secs_f64() * 1e9 / rays.len() as f64);
                }
                traced[index] = found;
            }
            phase.advance(1);
        }
        let base = median(&mut times[0].clone());
        for (index, method) in plan.methods.iter().enumerate() {
            let time = median(&mut times[index]);
            rows.push(Row {
                map: subject.name.clone(),
                side: subject.heights.size()[0],
                elevation,
                method: *method,
                steps: spread(&traced[index]),
                leaves: traced[index].iter().map(|one| f64::from(one.leaves)).sum::<f64>() / rays.len() as f64,
                time,
                ratio: time / base,
                errors: Errors::new(&rays, &truth, &traced[index]),
            });
        }
    }
    Ok(rows)
}

/// The map with the bounds of every method.
fn placed(subject: &Subject, plan: &Plan) -> Result<BTreeMap<Bounds, Placed>, Unplaceable> {
    let bounds: BTreeSet<Bounds> = plan.methods.iter().map(|method| method.bounds()).collect();
    bounds.into_iter().map(|one| Ok((one, Placed::new(&subject.heights, one, plan.limit)?))).collect()
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn spread(traced: &[Traced]) -> [f64; 3] {
    let mut steps: Vec<u32> = traced.iter().map(|one| one.steps).collect();
    steps.sort_unstable();
    let mean = steps.iter().map(|steps| f64::from(*steps)).sum::<f64>() / steps.len().max(1) as f64;
    let at = |index: usize| steps.get(index).copied().map_or(0.0, f64::from);
    [mean, at(steps.len() * 99 / 100), at(steps.len().saturating_sub(1))]
}
