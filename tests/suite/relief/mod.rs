//! Exact relief methods on the device against the reference in f64.

mod accuracy;

use terrane::relief::{Outcome, Segment, Traced, Tracer, shader};
use terrane::render::{Gpu, Selection};
use terrane_shaderlib::heightfield::adversary::{AIMS, Case, Depth, LANDS, Random, Rays, SIZES, map};
use terrane_shaderlib::heightfield::{Border, Heights, Ray, first_hit};
use terrane_shaderlib::relief::{Bounds, Method, Placed};

use crate::skip::Skip;
use crate::tint::{Module, Tint};

/// Steps of height by which a hit may be off: 2^-16 of the depth of a 16-bit map.
const STEP: f64 = 1.0;
/// Texels by which a hit may be off besides.
const TEXELS: f64 = 1e-3;
/// More nodes than any path of the test has.
const LIMIT: u32 = 1 << 20;

fn device() -> Option<Gpu> {
    Gpu::new(&Selection::Best).map_err(|error| Skip(error.to_string()).report()).ok()
}

/// The ray, so many steps higher.
fn raised(ray: &Ray, steps: f64) -> Ray {
    let [x, y, z] = ray.origin;
    Ray { origin: [x, y, z + steps], ..*ray }
}

/// What is wrong with an outcome: it must lie between the first hits of the ray a step lower and a step higher.
fn fault(heights: &Heights, Segment { ray, range }: &Segment, traced: &Traced) -> Option<String> {
    let fastest = ray.direction[0].abs().max(ray.direction[1].abs()).max(ray.direction[2].abs() / 131_072.0);
    let slack = TEXELS / fastest.max(f64::MIN_POSITIVE);
    let lowered = first_hit(heights, &raised(ray, -STEP), *range);
    let lifted = first_hit(heights, &raised(ray, STEP), *range);
    let text =
        |what: &str| Some(format!("{what}: {traced:?}, lower {lowered:?}, higher {lifted:?}, {ray:?} {range:?}"));
    match traced.outcome {
        Outcome::Unresolved => text("unresolved"),
        Outcome::Miss => lifted.filter(|hit| hit.t < range.1 - slack).and_then(|_| text("missed")),
        Outcome::Hit(t) if lowered.is_none_or(|hit| t < hit.t - slack) => text("too early"),
        Outcome::Hit(t) if lifted.is_some_and(|hit| t > hit.t + slack) => text("too late"),
        Outcome::Hit(_) => None,
    }
}

/// Adversarial maps that a device takes, with their rays.
fn lands(rays: usize, seed: u64) -> impl Iterator<Item = (Heights, Vec<Segment>)> {
    let mut random = Random::new(seed);
    let all = LANDS.iter().flat_map(|land| SIZES.iter().map(move |size| (*land, *size)));
    all.flat_map(|one| [(one, Border::Wrap), (one, Border::Clamp)]).filter_map(move |((land, size), border)| {
        let heights = map(land, size, border, Depth::Sixteen, random.bits()).ok()?;
        Placed::new(&heights, Bounds::None, LIMIT).ok()?;
        let mut source = Rays::new(&heights, random.bits());
        let cases: Vec<Case> = (0..rays).map(|index| source.case(AIMS[index % AIMS.len()])).collect();
        let sent = cases.iter().map(|case| Segment { ray: case.ray, range: (0.0, case.end as f64) }).collect();
        Some((heights, sent))
    })
}

fn judge(method: Method, rays: usize, seed: u64) -> Option<(usize, Vec<String>)> {
    let gpu = device()?;
    let (mut count, mut faults) = (0, Vec::new());
    for (heights, sent) in lands(rays, seed) {
        let placed = Placed::new(&heights, method.bounds(), LIMIT).expect("filtered above");
        let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
        let (traced, _) = tracer.trace(&sent).expect("the device answers");
        count += sent.len();
        faults.extend(sent.iter().zip(&traced).filter_map(|(segment, traced)| fault(&heights, segment, traced)));
    }
    Some((count, faults))
}

#[track_caller]
fn exact(method: Method) {
    let Some((count, faults)) = judge(method, 600, 1) else { return };
    assert!(count > 100_000, "only {count} rays");
    let first: Vec<&String> = faults.iter().take(8).collect();
    assert!(faults.is_empty(), "{method}: {} of {count} rays\n{first:#?}", faults.len());
}

#[test]
fn the_walk_is_exact() {
    exact(Method::Walk);
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
fn linear_search_is_not_and_the_judge_sees_it() {
    let Some((count, faults)) = judge(Method::Linear(64, 0), 96, 1) else { return };
    assert!(faults.len() > count / 20, "{} of {count}", faults.len());
}

#[test]
fn tint_accepts_every_method() {
    let Ok(mut tint) = Tint::start().map_err(Skip::report) else { return };
    let exact = [Method::Walk, Method::Sprint, Method::Wide, Method::MaximumMipmaps];
    let methods = exact.into_iter().chain([Method::Linear(32, 0), Method::Linear(32, 6)]);
    let modules: Vec<_> = methods.map(|method| Module::with_pipelines(method.to_string(), shader(method))).collect();
    for report in tint.validate(&modules) {
        assert!(report.errors().is_empty(), "{}: {}", report.name, report.errors());
        assert!(!report.pipelines.is_empty(), "{}: no pipeline was tried", report.name);
    }
}
