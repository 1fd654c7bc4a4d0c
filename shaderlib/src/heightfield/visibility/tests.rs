use super::*;
use crate::heightfield::adversary::{Depth, LANDS, Land, Random, map};
use crate::heightfield::{Border, Texels, visible};

/// Steps above the surface that points are raised by.
const LIFT: f64 = 2.0;
/// Texels that are looked over.
const REACH: f64 = 100.0;
const STEPS: f64 = 2000.0;

fn land(land: Land) -> Heights {
    map(land, [32, 32], Border::Wrap, Depth::Sixteen, 5).unwrap()
}

fn point(heights: &Heights, random: &mut Random) -> [f64; 3] {
    let [x, y] = [0, 1].map(|_| random.between(0, 32 * 256) as f64 / 256.0);
    [x, y, heights.surface(x, y) + LIFT]
}

/// Whether the sky is seen at an elevation: by the walk that looks for hits.
fn seen(heights: &Heights, from: [f64; 3], towards: [f64; 2], tangent: f64) -> bool {
    visible(heights, from, [towards[0], towards[1], tangent * STEPS], (0.0, REACH))
}

#[test]
fn a_horizon_is_where_sight_begins() {
    let mut random = Random::new(3);
    for heights in LANDS.map(land) {
        let visibility = Visibility::new(&heights, STEPS);
        for _ in 0..200 {
            let from = point(&heights, &mut random);
            let (sine, cosine) = (random.between(0, 6283) as f64 / 1000.0).sin_cos();
            let horizon = visibility.horizon(from, [cosine, sine], REACH);
            assert!(seen(&heights, from, [cosine, sine], horizon + 1e-6), "{horizon} hides too little at {from:?}");
            let below = horizon - 1e-6;
            assert!(below < 0.0 || !seen(&heights, from, [cosine, sine], below), "{horizon} at {from:?}");
        }
    }
}

#[test]
fn a_wall_hides_what_it_must() {
    let mut texels = vec![0; 64];
    (0..8).for_each(|row| texels[row * 8 + 6] = 1000);
    let heights = Heights::new([8, 8], Border::Clamp, Texels::U16(texels)).unwrap();
    let visibility = Visibility::new(&heights, 100.0);
    let from = [2.0, 3.5, 0.5];
    assert!((visibility.horizon(from, [1.0, 0.0], 50.0) - 9.995 / 4.0).abs() < 1e-12, "its crest, 4 texels away");
    assert!((visibility.horizon(from, [0.6, 0.8], 50.0) - 0.0).abs() < 1e-12, "the border comes first");
    assert_eq!(visibility.horizon(from, [1.0, 0.0], 3.0), 0.0, "beyond reach");
    assert_eq!(visibility.horizon([2.0, 3.5, 0.0], [1.0, 0.0], 50.0), f64::INFINITY, "the ground is solid");
    // Half of the wedge towards it, and none of the others: its horizon is one angle in all azimuths of one plane.
    let up = visibility.sky_share(from, [0.0, 0.0, 1.0], 4, 50.0);
    let cosine = 1.0 / (1.0 + (9.995_f64 / 4.0).powi(2));
    assert!((up - (3.0 + cosine) / 4.0).abs() < 1e-12, "{up}");
}

#[test]
fn open_land_sees_all_of_the_sky_and_a_slope_its_part() {
    let flat = land(Land::Low);
    let visibility = Visibility::new(&flat, STEPS);
    assert!((visibility.sky_share([3.0, 3.0, 1.0], [0.0, 0.0, 1.0], 16, 50.0) - 1.0).abs() < 1e-12);
    // A plane tilted by an angle sees (1 + cos) / 2 of an even sky that is whole above the map's plane.
    let (sine, cosine) = f64::sin_cos(0.5);
    let tilted = visibility.sky_share([3.0, 3.0, 1.0], [sine, 0.0, cosine], 4096, 50.0);
    assert!((tilted - 0.5 * (1.0 + cosine)).abs() < 1e-6, "{tilted}");
}

#[test]
fn the_disc_is_that_of_many_rays() {
    let heights = land(Land::Hills);
    let visibility = Visibility::new(&heights, STEPS);
    let (mut random, sun) = (Random::new(8), Sun::new(33.0, 40.0, 8.0));
    let mut partly = 0;
    for _ in 0..60 {
        let from = point(&heights, &mut random);
        let share = visibility.sun_share(from, &sun, 64, REACH);
        partly += u32::from((0.1..0.9).contains(&share));
        let counted = rays(&heights, from, &sun);
        // 64 × 64 rays: a line crosses at most 128 of their squares, and 1 / 64 of the chords each way.
        assert!((share - counted).abs() < 0.02, "{share}, {counted} at {from:?}");
    }
    assert!(partly > 5, "only {partly} points in the penumbra");
}

/// The share of rays to a disc that meet nothing.
fn rays(heights: &Heights, from: [f64; 3], sun: &Sun) -> f64 {
    let side = (0..64).map(|index| (f64::from(index) + 0.5) / 32.0 - 1.0);
    let disc: Vec<[f64; 2]> =
        side.clone().flat_map(|y| side.clone().map(move |x| [x, y])).filter(|[x, y]| x * x + y * y < 1.0).collect();
    let lit = disc.iter().filter(|[x, y]| seen(heights, from, sun.chord(*x), sun.tangent_at(*y))).count();
    lit as f64 / disc.len() as f64
}

#[test]
fn normals_are_those_of_the_surface() {
    let heights = land(Land::Noise);
    let visibility = Visibility::new(&heights, STEPS);
    for (x, y) in [(3.3, 4.6), (30.9, 31.2), (7.0, 8.5)] {
        let [a, b] = visibility.gradient(x, y);
        let slope = |i: f64, j: f64| (heights.surface(x + i, y + j) - heights.surface(x, y)) / (1e-6 * STEPS);
        assert!((a - slope(1e-6, 0.0)).abs() < 1e-4 && (b - slope(0.0, 1e-6)).abs() < 1e-4, "{a} {b}");
        let normal = visibility.normal(x, y);
        let length: f64 = normal.iter().map(|part| part * part).sum();
        assert!((length - 1.0).abs() < 1e-12 && (normal[0] + a * normal[2]).abs() < 1e-12);
    }
}
