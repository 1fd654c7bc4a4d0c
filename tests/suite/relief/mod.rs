//! Exact relief methods on the device against the reference in f64.

mod accuracy;
mod build;
mod chosen;
mod defects;
mod displacement;
mod fields;
mod figures;
mod lighting;
mod machine;
mod metamorphic;
mod objects;
mod parallax_shadow;
mod plain;
mod pops;
mod previewed;
mod refused;
mod rendered;
mod rounding;
mod scene;
mod sharing;
mod tiles;

use terrane::measure::Judge;
use terrane::relief::{Outcome, Segment, Traced, Tracer, shader, tiled_shader};
use terrane::render::{Gpu, Selection};
use terrane_shaderlib::heightfield::adversary::{AIMS, Case, Depth, LANDS, Random, Rays, SIZES, map};
use terrane_shaderlib::heightfield::{Border, Heights};
use terrane_shaderlib::relief::{Displacement, Method, Placed};

use crate::skip::Skip;
use crate::tint::{Module, Tint};

/// More nodes than any path of the test has.
const LIMIT: u32 = 1 << 15;

fn device() -> Option<Gpu> {
    Gpu::new(&Selection::Best).map_err(|error| Skip(error.to_string()).report()).ok()
}

/// What is wrong with an outcome, in words.
fn fault(heights: &Heights, segment: &Segment, traced: &Traced) -> Option<String> {
    let judge = Judge::new(heights, *segment);
    judge.fault(traced).map(|fault| format!("{fault:?}: {}", judge.describe(traced)))
}

/// Adversarial maps that a device takes, with their rays.
fn lands(rays: usize, seed: u64) -> impl Iterator<Item = (Heights, Vec<Segment>)> {
    let mut random = Random::new(seed);
    let all = LANDS.iter().flat_map(|land| SIZES.iter().map(move |size| (*land, *size)));
    all.flat_map(|one| [(one, Border::Wrap), (one, Border::Clamp)]).filter_map(move |((land, size), border)| {
        let heights = map(land, size, border, Depth::Sixteen, random.bits()).ok()?;
        let mut source = Rays::new(&heights, random.bits());
        let cases: Vec<Case> = (0..rays).map(|index| source.case(AIMS[index % AIMS.len()])).collect();
        let sent = cases.iter().map(|case| Segment { ray: case.ray, range: (0.0, case.end as f64) }).collect();
        Some((heights, sent))
    })
}

fn judge(method: Method, rays: usize, seed: u64) -> Option<(usize, Vec<String>)> {
    let placed = |heights: &Heights| Placed::new(heights, method.bounds(), LIMIT).expect("whole steps can be placed");
    judge_placed(method, &placed, rays, seed)
}

fn judge_placed(
    method: Method,
    placed: &dyn Fn(&Heights) -> Placed,
    rays: usize,
    seed: u64,
) -> Option<(usize, Vec<String>)> {
    let gpu = device()?;
    let (mut count, mut faults) = (0, Vec::new());
    for (heights, sent) in lands(rays, seed) {
        let placed = placed(&heights);
        let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
        let (traced, _) = tracer.trace(&sent).expect("the device answers");
        count += sent.len();
        faults.extend(sent.iter().zip(&traced).filter_map(|(segment, traced)| fault(&heights, segment, traced)));
    }
    Some((count, faults))
}

#[track_caller]
fn exact(method: Method) {
    let Some(judged) = judge(method, 600, 1) else { return };
    faultless(method, &judged);
}

#[track_caller]
fn faultless(method: Method, (count, faults): &(usize, Vec<String>)) {
    assert!(*count > 100_000, "only {count} rays");
    let first: Vec<&String> = faults.iter().take(8).collect();
    assert!(faults.is_empty(), "{method}: {} of {count} rays\n{first:#?}", faults.len());
}

#[test]
fn the_walk_is_exact() {
    exact(Method::Walk);
}

#[test]
fn robust_cones_are_exact() {
    exact(Method::RobustCone);
}

#[test]
fn the_stride_is_exact() {
    exact(Method::Stride);
}

#[test]
fn the_stride_over_quadrants_is_exact() {
    exact(Method::StrideQuadrants);
}

#[test]
fn the_leap_is_exact() {
    exact(Method::Leap);
}

#[test]
fn the_leap_from_coarse_nodes_down_is_exact() {
    let placed = |heights: &Heights| {
        let placed = Placed::new(heights, Method::Leap.bounds(), LIMIT).expect("whole steps can be placed");
        placed.begun_over_nodes()
    };
    let Some(judged) = judge_placed(Method::Leap, &placed, 600, 2) else { return };
    faultless(Method::Leap, &judged);
}

#[test]
fn the_sprint_is_exact() {
    exact(Method::Sprint);
}

#[test]
fn wide_is_exact() {
    exact(Method::Wide);
}

#[test]
fn maximum_mipmaps_are_exact() {
    exact(Method::MaximumMipmaps);
}

#[test]
fn the_repaired_quadtree_displacement_is_exact() {
    exact(Method::QuadtreeDisplacementRepaired);
}

#[test]
fn the_repaired_quadtree_relief_is_exact() {
    exact(Method::QuadtreeReliefExact);
}

#[test]
fn published_cones_are_not() {
    for method in [Method::ConeStep(0), Method::ConeStep(32), Method::RelaxedCone(32, 8)] {
        let Some((count, faults)) = judge(method, 96, 1) else { return };
        assert!(faults.len() > count / 50, "{method}: {} of {count}", faults.len());
    }
}

#[test]
fn a_search_that_is_cut_short_says_so() {
    let Some(gpu) = device() else { return };
    let (heights, sent) = lands(600, 1).find(|(heights, _)| heights.size() == [64, 64]).expect("one of the sizes");
    for method in [Method::RobustCone, Method::Leap, Method::Stride, Method::StrideQuadrants, Method::ConeStep(0)] {
        let trace = |limit| {
            let placed = Placed::new(&heights, method.bounds(), limit).expect("filtered");
            let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
            tracer.trace(&sent).expect("the device answers").0
        };
        let (whole, cut) = (trace(LIMIT), trace(2));
        let unresolved = cut.iter().filter(|one| one.outcome == Outcome::Unresolved).count();
        assert!(unresolved > 10, "{method}: {unresolved}");
        let same = |(cut, whole): (&Traced, &Traced)| cut.outcome == Outcome::Unresolved || cut == whole;
        assert!(cut.iter().zip(&whole).all(same), "{method}: an answer that is not that of the whole search");
    }
}

#[test]
fn the_walk_from_the_finest_node_up_is_exact() {
    exact(Method::ShadowHard);
}

#[test]
fn wide_nodes_from_the_finest_up_are_exact() {
    exact(Method::ShadowWide);
}

#[test]
fn linear_search_is_not_and_the_judge_sees_it() {
    let Some((count, faults)) = judge(Method::Linear(64, 0), 96, 1) else { return };
    assert!(faults.len() > count / 20, "{} of {count}", faults.len());
}

#[test]
fn tint_accepts_every_method() {
    let Ok(mut tint) = Tint::start().map_err(Skip::report) else { return };
    let displacement = Displacement { caps: Some([12, 48]), refines: true, stop: 320, ..Displacement::PUBLISHED };
    let methods = [
        Method::Walk,
        Method::Sprint,
        Method::Wide,
        Method::MaximumMipmaps,
        Method::ShadowHard,
        Method::ShadowWide,
        Method::Linear(32, 0),
        Method::Linear(32, 6),
        Method::ParallaxOffset(1280),
        Method::QuadtreeDisplacement(Displacement::LISTING),
        Method::QuadtreeDisplacement(displacement),
        Method::QuadtreeDisplacementRepaired,
        Method::QuadtreeRelief(0),
        Method::QuadtreeReliefExact,
        Method::RobustCone,
        Method::Leap,
        Method::Stride,
        Method::StrideQuadrants,
        Method::ConeStep(0),
        Method::ConeStep(16),
        Method::RelaxedCone(15, 8),
    ];
    let whole = methods.map(|method| Module::with_pipelines(method.to_string(), shader(method)));
    let tiled = methods.map(|method| Module::with_pipelines(format!("{method}, tile by tile"), tiled_shader(method)));
    let modules = [whole, tiled].concat();
    for report in tint.validate(&modules) {
        assert!(report.errors().is_empty(), "{}: {}", report.name, report.errors());
        assert!(!report.pipelines.is_empty(), "{}: no pipeline was tried", report.name);
    }
}
