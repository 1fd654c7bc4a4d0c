//! How far hits are off, how much a ray costs, and that it does not matter how far from the first tile it starts.

use terrane::measure::{BuiltIn, View};
use terrane::relief::{Outcome, Segment, Traced, Tracer};
use terrane_shaderlib::heightfield::adversary::{Depth, Land, map};
use terrane_shaderlib::heightfield::{Border, Heights, Hit, first_hit};
use terrane_shaderlib::relief::{Bounds, Method, Placed};

use super::{LIMIT, device};

/// The highest number, and how deep it is over the side of the map.
const FULL: f64 = 65535.0;
const DEPTH: f64 = 0.05;
const METHODS: [Method; 4] = [Method::Walk, Method::Sprint, Method::Leap, Method::Wide];

fn land(land: Land, side: u32) -> Heights {
    map(land, [side; 2], Border::Wrap, Depth::Sixteen, 1).expect("a side in range")
}

fn rays(heights: &Heights, elevation: f64) -> Vec<Segment> {
    View { elevation, depth: DEPTH, size: [320, 184] }.rays(heights, FULL)
}

fn traced(heights: &Heights, method: Method, sent: &[Segment]) -> Option<Vec<Traced>> {
    let gpu = device()?;
    let placed = Placed::new(heights, method.bounds(), LIMIT).expect("its sides are powers of two");
    let tracer = Tracer::new(&gpu, heights, &placed, method).expect("the device takes it");
    Some(tracer.trace(sent).expect("the device answers").0)
}

/// The sine between ray and ground, in a space where a step of height is as long as it is deep.
fn incidence(heights: &Heights, Segment { ray, .. }: &Segment, hit: &Hit) -> f64 {
    let step = DEPTH * f64::from(heights.size()[0]) / FULL;
    let [a, b, c, d] = heights.corners(hit.cell[0], hit.cell[1]);
    let [u, v] = hit.uv;
    let slope = [(b - a) * (1.0 - v) + (d - c) * v, (c - a) * (1.0 - u) + (d - b) * u].map(|rise| rise * step);
    let normal = [-slope[0], -slope[1], 1.0];
    let [x, y, z] = ray.direction;
    let direction = [x, y, z * step];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    dot(normal, direction).abs() / (dot(normal, normal) * dot(direction, direction)).sqrt()
}

/// Texels along the ground between each hit and the true one, where the ray does not graze.
fn distances(heights: &Heights, sent: &[Segment], traced: &[Traced]) -> Vec<f64> {
    let distance = |(segment, traced): (&Segment, &Traced)| {
        let hit = first_hit(heights, &segment.ray, segment.range)?;
        let Outcome::Hit(t) = traced.outcome else { return Some(f64::INFINITY) };
        let [x, y, _] = segment.ray.direction;
        (incidence(heights, segment, &hit) > 0.01).then(|| (t - hit.t).abs() * x.hypot(y))
    };
    let mut distances: Vec<f64> = sent.iter().zip(traced).filter_map(distance).collect();
    distances.sort_by(f64::total_cmp);
    distances
}

#[test]
fn hits_are_a_thousandth_of_a_texel_off_and_at_most_two_hundredths() {
    for (kind, elevation) in [(Land::Hills, 8.0), (Land::Cracks, 20.0), (Land::Noise, 20.0), (Land::Walls, 8.0)] {
        let heights = land(kind, 1024);
        let sent = rays(&heights, elevation);
        for method in METHODS {
            let Some(traced) = traced(&heights, method, &sent) else { return };
            let distances = distances(&heights, &sent, &traced);
            assert!(distances.len() > sent.len() / 2, "{method} on {kind:?}: only {} hits", distances.len());
            let (rare, most) = (distances[distances.len() * 999 / 1000], distances[distances.len() - 1]);
            assert!(rare <= 1e-3 && most <= 0.02, "{method} on {kind:?}: p99.9 {rare}, most {most}");
        }
    }
}

#[test]
fn a_million_tiles_away_hits_are_the_same() {
    let heights = land(Land::Cracks, 256);
    let lid = Placed::new(&heights, Bounds::None, LIMIT).expect("its sides are powers of two").range[1] + 1.0;
    // Starts in whole 256ths of a texel, which f64 holds a million tiles away as well, and where the device's rays start.
    let near = rays(&heights, 20.0).into_iter().map(|mut segment| {
        let [x, y, _] = segment.ray.origin.map(|at| (at * 256.0).round() / 256.0);
        segment.ray.origin = [x, y, lid];
        segment
    });
    let near: Vec<Segment> = near.collect();
    let far = near.iter().map(|segment| {
        let mut far = *segment;
        far.ray.origin[0] += 256e6;
        far.ray.origin[1] -= 256e6;
        far
    });
    let far: Vec<Segment> = far.collect();
    for method in METHODS {
        let (Some(here), Some(there)) = (traced(&heights, method, &near), traced(&heights, method, &far)) else {
            return;
        };
        assert!(here.iter().any(|one| matches!(one.outcome, Outcome::Hit(_))));
        // The cell counts from the first tile, all else is the same to the last bit.
        let brought = there.into_iter().map(|one| match one.outcome {
            Outcome::Hit(_) => Traced { cell: [one.cell[0] - 256_000_000, one.cell[1] + 256_000_000], ..one },
            _ => one,
        });
        assert_eq!(here, brought.collect::<Vec<_>>(), "{method}");
    }
}

#[test]
fn wide_takes_few_loads() {
    let rock = BuiltIn::named("cracked_rock").expect("a map of that name").make(1024).heights;
    for (what, heights, most) in [("hills", land(Land::Hills, 1024), 7.5), ("cracked rock", rock, 10.0)] {
        let sent = rays(&heights, 20.0);
        let Some(traced) = traced(&heights, Method::Wide, &sent) else { return };
        let loads: u32 = traced.iter().map(|one| one.steps + one.leaves).sum();
        let mean = f64::from(loads) / sent.len() as f64;
        assert!(mean <= most, "{what}: {mean} nodes and patches a ray");
    }
}
