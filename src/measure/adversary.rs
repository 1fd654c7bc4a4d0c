//! Exact methods against rays on which methods fail: every fault is counted, and how far off the hits are.

use std::fmt::Write as _;

use rayon::prelude::*;
use terrane_shaderlib::heightfield::adversary::{AIMS, Depth, LANDS, Land, Random, Rays, SIZES, map};
use terrane_shaderlib::heightfield::{Border, Heights};
use terrane_shaderlib::relief::{Method, Placed};

use super::histogram::Histogram;
use super::judge::Judge;
use crate::relief::{Outcome, Segment, Traced, Tracer};
use crate::render::{Gpu, Progress, RenderError};

/// What is traced.
#[derive(Clone, Debug)]
pub struct Attack {
    /// Exact ones.
    pub methods: Vec<Method>,
    /// How many rays, give or take a batch.
    pub rays: u64,
    /// Other rays for each.
    pub seed: u64,
}

/// What became of the rays of one method.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The method.
    pub method: Method,
    /// All rays.
    pub rays: u64,
    /// Those that hit.
    pub hits: u64,
    /// Those of each kind of [`Fault`](super::Fault), in its order.
    pub by_fault: [u64; 4],
    /// Those that would be faults, but for a ray beside this one by no more than f32 lacks: see [`Judge::is_beside`].
    pub beside: u64,
    /// Right hits away from the true ones, of rays of which rounding decides what they meet: they pass a place so closely.
    pub decided: u64,
    /// Texels between the other hits and the true ones, without rays that graze.
    pub distances: Histogram,
    /// The first faults in words.
    pub first: Vec<String>,
    /// The first of the other hits that are more than 0.02 texels off, in words.
    pub far: Vec<String>,
}

/// Beyond what the adversary's small maps have: long paths.
const LONG: [[u32; 2]; 2] = [[512, 512], [300, 700]];
/// Nodes after which a search counts as stuck: more than any path has.
const LIMIT: u32 = 1 << 15;
/// Rays in a batch at most.
const BATCH: u64 = 1 << 15;
/// Texels by which no hit may be off, where rounding does not decide what is met.
const FAR: f64 = 0.02;
/// Faults, and hits far off, that are told in words.
const TOLD: usize = 8;
/// Batches after which `--verbose` says how it stands.
const TELL: usize = 64;

/// One map and its rays.
struct Batch {
    /// What makes the map anew.
    name: String,
    heights: Heights,
    /// Whether searches that can begin over coarse nodes, as over large maps.
    begins_over_nodes: bool,
    rays: Vec<Segment>,
}

/// Kinds of maps: one batch of rays for each, then all of them again.
fn kinds() -> impl Iterator<Item = (Land, [u32; 2], Border, Depth)> + Clone {
    let sizes = SIZES.into_iter().chain(LONG);
    let lands = LANDS.into_iter().flat_map(move |land| sizes.clone().map(move |size| (land, size)));
    let borders = lands.flat_map(|(land, size)| [Border::Wrap, Border::Clamp].map(|border| (land, size, border)));
    borders.flat_map(|(land, size, border)| [Depth::Sixteen, Depth::Eight].map(|depth| (land, size, border, depth)))
}

fn batches(attack: &Attack) -> impl Iterator<Item = Batch> {
    let mut random = Random::new(attack.seed);
    let all = kinds().count() as u64;
    let size = attack.rays.div_ceil(all).clamp(AIMS.len() as u64, BATCH);
    let count = attack.rays.div_ceil(size);
    kinds().cycle().take(count as usize).map(move |(land, sides, border, depth)| {
        let (variant, seed) = (random.bits(), random.bits());
        let name = format!("{land:?} {sides:?} {border:?} {depth:?}, map {variant:#x}, rays {seed:#x}");
        let heights = map(land, sides, border, depth, variant).expect("every size is in range");
        let mut source = Rays::new(&heights, seed);
        let cases = (0..size as usize).map(|index| source.case(AIMS[index % AIMS.len()]));
        let rays = cases.map(|case| Segment { ray: case.ray, range: (0.0, case.end as f64) }).collect();
        Batch { name, heights, begins_over_nodes: variant & 1 == 1, rays }
    })
}

/// Traces adversarial rays by every method. While the device traces a batch, the cores judge the one before it.
///
/// # Errors
/// Where the device refuses or fails.
pub fn attack(gpu: &Gpu, attack: &Attack, progress: Progress) -> Result<Vec<Verdict>, RenderError> {
    // Each method is compiled twice and then moved from map to map.
    let smallest = [[1, 1], [3, 3]].map(|size| map(Land::Low, size, Border::Wrap, Depth::Eight, 0));
    let compiled = attack.methods.iter().map(|method| {
        let tracers =
            smallest.iter().flatten().map(|heights| Tracer::new(gpu, heights, &placed(heights, *method), *method));
        tracers.collect::<Result<Vec<_>, _>>()
    });
    let compiled = compiled.collect::<Result<Vec<_>, _>>()?;
    let mut verdicts: Vec<Verdict> = attack.methods.iter().map(|method| Verdict::new(*method)).collect();
    let phase = progress.phase("adversary", attack.rays);
    let mut before: Option<(Batch, Vec<Vec<Traced>>)> = None;
    for (index, batch) in batches(attack).enumerate() {
        let (traced, more) = rayon::join(
            || trace(&compiled, &attack.methods, &batch),
            || before.as_ref().map(|(batch, traced)| judge(batch, traced, &verdicts)),
        );
        verdicts = more.unwrap_or(verdicts);
        phase.advance(batch.rays.len() as u64);
        before = Some((batch, traced?));
        if index % TELL == TELL - 1 {
            log::debug!("{}", table(&verdicts));
        }
    }
    Ok(before.map(|(batch, traced)| judge(&batch, &traced, &verdicts)).unwrap_or(verdicts))
}

fn placed(heights: &Heights, method: Method) -> Placed {
    Placed::new(heights, method.bounds(), LIMIT).expect("maps of whole steps can be placed")
}

/// What each method makes of each ray.
fn trace(compiled: &[Vec<Tracer<'_>>], methods: &[Method], batch: &Batch) -> Result<Vec<Vec<Traced>>, RenderError> {
    let traced = compiled.iter().zip(methods).map(|(tracers, method)| {
        let placed = placed(&batch.heights, *method);
        let placed = if batch.begins_over_nodes { placed.begun_over_nodes() } else { placed };
        let tracer = tracers[usize::from(placed.tiled)].over(&batch.heights, &placed)?;
        Ok(tracer.trace(&batch.rays)?.0)
    });
    traced.collect()
}

/// The verdicts so far and those on a batch.
fn judge(batch: &Batch, traced: &[Vec<Traced>], before: &[Verdict]) -> Vec<Verdict> {
    let none = || before.iter().map(|verdict| Verdict::new(verdict.method)).collect::<Vec<_>>();
    let both = |mut all: Vec<Verdict>, more: Vec<Verdict>| {
        all.iter_mut().zip(&more).for_each(|(all, more)| all.join(more));
        all
    };
    let one = |mut verdicts: Vec<Verdict>, (index, segment): (usize, &Segment)| {
        let judge = Judge::new(&batch.heights, *segment);
        verdicts.iter_mut().zip(traced).for_each(|(verdict, traced)| verdict.add(&judge, &traced[index], &batch.name));
        verdicts
    };
    let found = batch.rays.par_iter().enumerate().with_min_len(256).fold(none, one).reduce(none, both);
    both(before.to_vec(), found)
}

impl Verdict {
    fn new(method: Method) -> Self {
        let distances = Histogram::default();
        Self {
            method,
            rays: 0,
            hits: 0,
            by_fault: [0; 4],
            beside: 0,
            decided: 0,
            distances,
            first: Vec::new(),
            far: Vec::new(),
        }
    }

    /// All that is wrong.
    #[must_use]
    pub fn faults(&self) -> u64 {
        self.by_fault.iter().sum()
    }

    fn add(&mut self, judge: &Judge<'_>, traced: &Traced, on: &str) {
        self.rays += 1;
        self.hits += u64::from(matches!(traced.outcome, Outcome::Hit(_)));
        if let Some(fault) = judge.fault(traced) {
            if judge.is_beside(traced) {
                self.beside += 1;
                return;
            }
            self.by_fault[fault as usize] += 1;
            tell(&mut self.first, &[format!("{}: {fault:?}: {}, {on}", self.method, judge.describe(traced))]);
            return;
        }
        match judge.distance(traced) {
            Some(distance) if judge.is_excused(traced, distance) => self.decided += 1,
            Some(distance) => {
                self.distances.add(distance);
                if distance > FAR {
                    let text = format!("{}: {distance} texels off: {}, {on}", self.method, judge.describe(traced));
                    tell(&mut self.far, &[text]);
                }
            }
            None => {}
        }
    }

    fn join(&mut self, more: &Self) {
        self.rays += more.rays;
        self.hits += more.hits;
        self.beside += more.beside;
        self.decided += more.decided;
        self.by_fault.iter_mut().zip(more.by_fault).for_each(|(count, more)| *count += more);
        self.distances.join(&more.distances);
        tell(&mut self.first, &more.first);
        tell(&mut self.far, &more.far);
    }
}

fn tell(told: &mut Vec<String>, more: &[String]) {
    let room = TOLD.saturating_sub(told.len());
    told.extend(more.iter().take(room).cloned());
}

/// The verdicts as a table. Distances are texels.
#[must_use]
pub fn table(verdicts: &[Verdict]) -> String {
    let head = ["rays", "hits", "unresolved", "missed", "early", "late", "beside", "decided", "p99.9", "max"];
    let mut text = format!("{:32}", "method") + &head.map(|name| format!(" {name:>11}")).concat() + "\n";
    for verdict in verdicts {
        let Verdict {
            method, rays, hits, by_fault: [given_up, missed, early, late], beside, decided, distances, ..
        } = verdict;
        let counts = [*rays, *hits, *given_up, *missed, *early, *late, *beside, *decided];
        let counts = counts.map(|count| format!(" {count:>11}")).concat();
        let errors = [distances.quantile(0.999), distances.max()].map(|error| format!(" {error:>11.1e}")).concat();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:32}{counts}{errors}", method.to_string());
    }
    text
}
