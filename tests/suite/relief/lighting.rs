//! Shadow and occlusion on the device against dense visibility in f64.

use rayon::prelude::*;
use terrane::measure::{MAPS, Subject};
use terrane::relief::{LIFT, Lighter, Lighting, Scene, Seen, Segment, Tracer, Turn};
use terrane::render::Gpu;
use terrane_shaderlib::heightfield::adversary::{Depth, LANDS, Land, Random, map};
use terrane_shaderlib::heightfield::visibility::{Sun, Visibility};
use terrane_shaderlib::heightfield::{Border, Heights, Ray};
use terrane_shaderlib::relief::{Method, Placed};

use super::{LIMIT, device, fault, lands};
use crate::skip::Skip;
use crate::tint::{Module, Tint};

/// How deep the built-in maps are here, over their side.
const DEPTH: f64 = 0.05;

/// Chords of the sun's disc in the reference.
const CHORDS: u32 = 24;

/// A map under a sun, and what is known of it.
pub(super) struct Place<'a> {
    pub(super) heights: &'a Heights,
    pub(super) visibility: Visibility<'a>,
    pub(super) scene: Scene,
}

impl<'a> Place<'a> {
    pub(super) fn new(Subject { heights, full, .. }: &'a Subject, sun: Sun) -> Self {
        let side = f64::from(heights.size()[0]);
        let steps = full / (DEPTH * side);
        let scene = Scene { sun, steps, reach: 2.0 * side };
        Self { heights, visibility: Visibility::new(heights, steps), scene }
    }

    /// Points that face the sun, in a grid of so many a side that is no grid of texels.
    pub(super) fn facing(&self, count: u32) -> Vec<[f64; 2]> {
        let side = self.heights.cells().map(|side| f64::from(side) / f64::from(count));
        let grid = (0..count * count).map(|index| [index % count, index / count].map(f64::from));
        let points = grid.map(|[x, y]| [(x + 0.37) * side[0], (y + 0.61) * side[1]]);
        let Sun { towards, tangent, .. } = self.scene.sun;
        points
            .filter(|[x, y]| {
                let normal = self.visibility.normal(*x, *y);
                normal[0] * towards[0] + normal[1] * towards[1] + normal[2] * tangent > 0.0
            })
            .collect()
    }

    /// A point as the device raises it.
    pub(super) fn raised(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        [x, y, self.heights.surface(x, y) + LIFT]
    }

    pub(super) fn sun_shares(&self, points: &[[f64; 2]], chords: u32) -> Vec<f64> {
        let share =
            |at: &[f64; 2]| self.visibility.sun_share(self.raised(*at), &self.scene.sun, chords, self.scene.reach);
        points.par_iter().map(share).collect()
    }

    pub(super) fn sky_shares(&self, points: &[[f64; 2]], azimuths: u32) -> Vec<f64> {
        let share = |at: &[f64; 2]| {
            let normal = self.visibility.normal(at[0], at[1]);
            self.visibility.sky_share(self.raised(*at), normal, azimuths, self.scene.reach)
        };
        points.par_iter().map(share).collect()
    }

    pub(super) fn seen(&self, gpu: &Gpu, lighting: Lighting, points: &[[f64; 2]]) -> Vec<Seen> {
        let placed = Placed::new(self.heights, lighting.bounds(), LIMIT).expect("the map can be placed");
        let lighter = Lighter::new(gpu, self.heights, &placed, lighting, self.scene).expect("the device takes it");
        lighter.see(points).expect("the device answers").0
    }
}

/// Differences of shares from the truth; one that was given up is off by more than any.
pub(super) fn differences(seen: &[Seen], truth: &[f64]) -> Vec<f64> {
    seen.iter().zip(truth).map(|(seen, truth)| seen.share.map_or(2.0, |share| share - truth)).collect()
}

pub(super) fn rmse(differences: &[f64]) -> f64 {
    (differences.iter().map(|off| off * off).sum::<f64>() / differences.len() as f64).sqrt()
}

pub(super) fn largest(differences: &[f64]) -> f64 {
    differences.iter().fold(0.0, |largest: f64, off| largest.max(off.abs()))
}

/// Maps with blockers of every kind.
pub(super) fn subjects(side: u32) -> Vec<Subject> {
    let subjects: Vec<Subject> = MAPS.iter().map(|map| map.make(side)).collect();
    assert!(subjects.len() >= 7, "only {} maps", subjects.len());
    subjects
}

/// Rays from points of the surface, raised as the device raises them, any way up.
fn leaving(heights: &Heights, count: usize, seed: u64) -> Vec<Segment> {
    let mut random = Random::new(seed);
    let mut ray = || {
        let cells = heights.cells();
        // Whole, half and other places: corners, edges, diagonals.
        let grain = random.one_of(&[1, 2, 256]);
        let [x, y] = cells.map(|side| random.between(0, i64::from(side) * grain) as f64 / grain as f64);
        let way = [(); 2].map(|()| random.between(-8, 8) as f64);
        let steps = 65535.0 / f64::from(cells[0].max(cells[1])) * random.one_of(&[0.1, 1.0, 5.0, 40.0]);
        let climb = random.between(0, 16) as f64 * steps;
        Segment {
            ray: Ray { origin: [x, y, heights.surface(x, y) + LIFT], direction: [way[0], way[1], climb] },
            range: (0.0, 100.0),
        }
    };
    (0..count).map(|_| ray()).collect()
}

#[test]
fn hard_shadows_are_exact_where_rays_leave_the_ground() {
    [Method::ShadowHard, Method::ShadowWide].into_iter().for_each(leaves_the_ground);
}

fn leaves_the_ground(method: Method) {
    let Some(gpu) = device() else { return };
    let (mut count, mut shadowed, mut faults) = (0, 0, Vec::new());
    for (seed, (heights, _)) in lands(1, 7).enumerate() {
        let placed = Placed::new(&heights, method.bounds(), LIMIT).expect("filtered before");
        let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
        let sent = leaving(&heights, 400, seed as u64);
        let (traced, _) = tracer.trace(&sent).expect("the device answers");
        count += sent.len();
        shadowed += traced.iter().filter(|one| matches!(one.outcome, terrane::relief::Outcome::Hit(_))).count();
        faults.extend(sent.iter().zip(&traced).filter_map(|(segment, traced)| fault(&heights, segment, traced)));
    }
    assert!(count > 60_000 && shadowed > count / 20 && shadowed < count / 2, "{shadowed} shadows of {count}");
    let first: Vec<&String> = faults.iter().take(8).collect();
    assert!(faults.is_empty(), "{method}: {} of {count} rays\n{first:#?}", faults.len());
}

#[test]
fn a_lower_sun_never_lights_more() {
    let Some(gpu) = device() else { return };
    let mut gone = 0;
    for (index, land) in LANDS.into_iter().enumerate() {
        let heights = map(land, [64, 64], Border::Wrap, Depth::Sixteen, 3).expect("a size that maps have");
        let subject = Subject { name: format!("{land:?}"), heights, full: 65535.0 };
        let mut before: Option<Vec<Seen>> = None;
        // So far apart that no horizon is within rounding of two of them.
        for elevation in [75.0, 60.0, 45.0, 30.0, 15.0, 5.0] {
            let place = Place::new(&subject, Sun::new(40.0 * index as f64, elevation, 0.3));
            let points: Vec<[f64; 2]> =
                (0..512_u32).map(|n| [f64::from(n % 32) * 2.03, f64::from(n / 32) * 4.01]).collect();
            let seen = place.seen(&gpu, Lighting::Hard, &points);
            for (lower, higher) in seen.iter().zip(before.iter().flatten()) {
                assert!(lower.share <= higher.share, "{land:?} at {elevation}: {lower:?}, {higher:?}");
                gone += u32::from(lower.share < higher.share);
            }
            before = Some(seen);
        }
    }
    assert!(gone > 500, "only {gone} points ever lost the sun");
}

/// Root mean square error of a method over the points of a map that face the sun.
fn sun_error(gpu: &Gpu, subject: &Subject, sun: Sun, lighting: Lighting) -> (f64, usize) {
    let place = Place::new(subject, sun);
    let points = place.facing(32);
    let truth = place.sun_shares(&points, CHORDS);
    let partly = truth.iter().filter(|share| (0.01..0.99).contains(*share)).count();
    (rmse(&differences(&place.seen(gpu, lighting, &points), &truth)), partly)
}

#[test]
fn soft_shadows_are_those_of_the_disc() {
    let Some(gpu) = device() else { return };
    let mut penumbra = 0;
    let ends = map(Land::Cracks, [100, 36], Border::Clamp, Depth::Sixteen, 2).expect("a size that maps have");
    let ends = Subject { name: "cracks that end".into(), heights: ends, full: 65535.0 };
    for subject in subjects(128).into_iter().chain([ends]) {
        // The sun; and a light ten times as wide, whose azimuths differ enough to need planes of their own.
        for (elevation, radius, few) in [(30.0, 0.27, 1), (15.0, 0.27, 1), (30.0, 3.0, 5)] {
            let off =
                |planes| sun_error(&gpu, &subject, Sun::new(34.0, elevation, radius), Lighting::Cone(planes, 0.0));
            // Chord for chord only rounding is left: one false shadow among a thousand points would be 0.03.
            let (error, partly) = off(CHORDS);
            assert!(error <= 1e-4, "{} at {elevation}: off by {error} where all chords are the same", subject.name);
            penumbra += partly;
            // A tip is narrower than the sun: a plane passes it or does not, and says nothing of the other chords.
            if !["needles", "noise"].contains(&subject.name.as_str()) {
                let (error, _) = off(few);
                assert!(error <= 0.02, "{} at {elevation}: {few} planes are off by {error}", subject.name);
            }
        }
    }
    assert!(penumbra > 500, "only {penumbra} points in a penumbra");
}

#[test]
fn a_coarse_cone_is_never_too_bright() {
    let Some(gpu) = device() else { return };
    let mut darker = 0;
    for subject in subjects(128) {
        let place = Place::new(&subject, Sun::new(34.0, 20.0, 3.0));
        let points = place.facing(32);
        let exact = place.seen(&gpu, Lighting::Cone(3, 0.0), &points);
        let coarse = place.seen(&gpu, Lighting::Cone(3, 16.0), &points);
        for (coarse, exact) in coarse.iter().zip(&exact) {
            let (coarse, exact) = (coarse.share.expect("resolved"), exact.share.expect("resolved"));
            assert!(coarse <= exact + 1e-3, "{}: {coarse}, exactly {exact}", subject.name);
            darker += u32::from(coarse < exact - 1e-3);
        }
    }
    assert!(darker > 20, "only {darker} points are darker: nothing was coarse");
}

#[test]
fn occlusion_is_that_of_its_directions() {
    let Some(gpu) = device() else { return };
    for subject in subjects(64) {
        let place = Place::new(&subject, Sun::new(0.0, 89.0, 0.3));
        let points = place.facing(24);
        let off =
            differences(&place.seen(&gpu, Lighting::Sky(8, Turn::Fixed, 0.0), &points), &place.sky_shares(&points, 8));
        // Rounding moves a horizon by a step and a thousandth of a texel; a wall is 65535 steps a texel.
        assert!(largest(&off) < 0.02 && rmse(&off) < 1e-3, "{}: {} {}", subject.name, largest(&off), rmse(&off));
    }
}

#[test]
fn small_rises_that_are_passed_over_only_let_a_little_light_in() {
    let Some(gpu) = device() else { return };
    let tolerance = 0.0625;
    for subject in subjects(128) {
        let place = Place::new(&subject, Sun::new(0.0, 89.0, 0.3));
        let points = place.facing(24);
        let [exact, fast] = [0.0, tolerance].map(|one| place.seen(&gpu, Lighting::Sky(4, Turn::Fixed, one), &points));
        let more = |(exact, fast): (&Seen, &Seen)| fast.share.expect("resolved") - exact.share.expect("resolved");
        let more: Vec<f64> = exact.iter().zip(&fast).map(more).collect();
        // A share falls by at most twice what the tangent of all horizons rises by.
        let allowed = -1e-3..=2.0 * f64::from(tolerance) + 1e-3;
        assert!(more.iter().all(|more| allowed.contains(more)), "{}: by {}", subject.name, largest(&more));
        let mean = more.iter().sum::<f64>() / more.len() as f64;
        assert!(mean <= f64::from(tolerance) / 4.0, "{}: {mean} too bright", subject.name);
        let loads = |seen: &[Seen]| seen.iter().map(|one| one.steps + one.leaves).sum::<u32>();
        assert!(loads(&fast) <= loads(&exact), "{}: {} loads, {} without", subject.name, loads(&fast), loads(&exact));
        if ["hills", "cracked_rock", "pebbles"].contains(&&*subject.name) {
            assert!(4 * loads(&fast) < 3 * loads(&exact), "{}: nothing is gained", subject.name);
        }
    }
}

#[test]
fn more_directions_come_closer_to_the_sky() {
    let Some(gpu) = device() else { return };
    for subject in subjects(64).iter().filter(|subject| ["cracked_rock", "pebbles"].contains(&subject.name.as_str())) {
        let place = Place::new(subject, Sun::new(0.0, 89.0, 0.3));
        let points = place.facing(24);
        let truth = place.sky_shares(&points, 128);
        let error = |lighting| rmse(&differences(&place.seen(&gpu, lighting, &points), &truth));
        let [four, eight, sixteen] = [4, 8, 16].map(|count| error(Lighting::Sky(count, Turn::Fixed, 0.0)));
        assert!(sixteen < eight && eight < four && four < 0.1, "{}: {four} {eight} {sixteen}", subject.name);
        let fast = error(Lighting::FastSky(8, Turn::Fixed, 6));
        assert!(fast > eight, "the fast horizon is no better than the exact one: {fast} {eight}");
        // Jitter turns the error of a direction into noise: it must not be larger.
        let jittered = error(Lighting::Sky(4, Turn::Jittered, 0.0));
        assert!(jittered < 1.5 * four, "{}: {jittered} {four}", subject.name);
    }
}

#[test]
fn tint_accepts_every_question_about_the_light() {
    let Ok(mut tint) = Tint::start().map_err(Skip::report) else { return };
    let scene = Scene { sun: Sun::new(30.0, 20.0, 0.3), steps: 1280.0, reach: 100.0 };
    let all = [
        Lighting::Hard,
        Lighting::ParallaxPublished,
        Lighting::Parallax(16),
        Lighting::Published,
        Lighting::FastHorizon(8),
        Lighting::Cone(3, 0.5),
        Lighting::Sky(8, Turn::Jittered, 0.0625),
        Lighting::FastSky(4, Turn::Fixed, 6),
    ];
    let modules = all.map(|one| Module::with_pipelines(format!("{one:?}"), one.shader(&scene, 65535.0)));
    for report in tint.validate(&modules) {
        assert!(report.errors().is_empty(), "{}: {}", report.name, report.errors());
        assert!(!report.pipelines.is_empty(), "{}: no pipeline was tried", report.name);
    }
}
