//! What noise is: an even mean, no period, no preferred grid, and the slope that it says it has.

use terrane_codegen::machine::{F32, Value};

use super::call::{Place, all_at_places, at_places};
use super::ranges::Random;

const POINTS: usize = 20_000;

fn f(value: f32) -> Value<F32> {
    Value::f32(&[value])
}

fn u(value: u32) -> Value<F32> {
    Value::u32(&[value])
}

/// Places spread over 100 km by 100 km.
fn places(seed: u64) -> Vec<Place> {
    let mut random = Random(seed);
    let mut coordinate = || random.between(-50_000.0, 50_000.0);
    let mut one = |_| {
        let (x, z) = (coordinate(), coordinate());
        let corner = [x, z].map(|x| (x.floor() * 256.0) as i32);
        Place::new(corner, (x - x.floor()) as f32, (z - z.floor()) as f32)
    };
    (0..POINTS).map(&mut one).collect()
}

fn mean(values: &[f32]) -> f64 {
    values.iter().map(|value| f64::from(*value)).sum::<f64>() / values.len() as f64
}

fn deviation(values: &[f32]) -> f64 {
    let mean = mean(values);
    (values.iter().map(|value| (f64::from(*value) - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}

fn correlation(a: &[f32], b: &[f32]) -> f64 {
    let (mean_a, mean_b) = (mean(a), mean(b));
    let pairs = a.iter().zip(b).map(|(a, b)| (f64::from(*a) - mean_a) * (f64::from(*b) - mean_b));
    pairs.sum::<f64>() / a.len() as f64 / (deviation(a) * deviation(b))
}

/// Name, arguments, mean and least deviation.
fn noises() -> Vec<(&'static str, Vec<Value<F32>>, f64, f64)> {
    vec![
        ("value_noise", vec![f(8.0), u(0)], 0.5, 0.15),
        ("gradient_noise", vec![f(8.0), u(0)], 0.5, 0.12),
        ("value_gradient_noise", vec![f(8.0), u(0)], 0.5, 0.12),
        ("fbm", vec![f(32.0), u(5), f(0.5), u(0)], 0.5, 0.14),
        ("billow", vec![f(16.0), u(4), f(0.5), u(0)], 0.357, 0.06),
        ("cell_random", vec![f(4.0), u(0)], 0.5, 0.28),
    ]
}

#[test]
fn means_are_even_and_seeds_are_independent() {
    for (function, arguments, expected, least) in noises() {
        let places = places(1);
        let values = at_places(function, &places, &arguments);
        assert!((mean(&values) - expected).abs() < 0.01, "{function}: mean {}", mean(&values));
        assert!(deviation(&values) > least, "{function}: deviation {}", deviation(&values));
        let mut other = arguments.clone();
        *other.last_mut().expect("the seed is last") = u(1);
        let related = correlation(&values, &at_places(function, &places, &other));
        assert!(related.abs() < 0.03, "{function}: seeds correlate by {related}");
    }
}

#[test]
fn noise_has_no_period() {
    for (function, arguments, ..) in noises() {
        let here = places(2);
        let values = at_places(function, &here, &arguments);
        for shift in [96, 128, 256, 1024, 8192, 65_536, 1_000_000] {
            let moved: Vec<Place> =
                here.iter().map(|at| Place { origin: [at.origin[0] + 256 * shift, at.origin[1]], ..*at }).collect();
            let related = correlation(&values, &at_places(function, &moved, &arguments));
            assert!(related.abs() < 0.04, "{function}: shift {shift} m correlates by {related}");
        }
    }
}

/// No direction is special: how alike two points are depends on their distance alone.
#[test]
fn fbm_is_alike_in_all_directions() {
    let arguments = [f(32.0), u(5), f(0.5), u(0)];
    let here = places(3);
    let values = at_places("fbm", &here, &arguments);
    let related: Vec<f64> = (0..8)
        .map(|step| {
            let (south, east) = (f64::from(step) * std::f64::consts::PI / 8.0).sin_cos();
            let moved = here.iter().map(|at| Place {
                local: [at.local[0] + 8.0 * east as f32, 0.0, at.local[2] + 8.0 * south as f32],
                ..*at
            });
            correlation(&values, &at_places("fbm", &moved.collect::<Vec<_>>(), &arguments))
        })
        .collect();
    let (low, high) = related.iter().fold((1.0, -1.0), |(low, high), x| (x.min(low), x.max(high)));
    assert!(high - low < 0.05, "{related:?}");
}

/// Central differences over a step that balances truncation and rounding; steeper noise has larger errors.
#[test]
fn slopes_are_true() {
    let cases = [
        ("value_noise", "value_noise_derivative", vec![f(8.0), u(3)]),
        ("gradient_noise", "gradient_noise_derivative", vec![f(8.0), u(3)]),
        ("fbm", "fbm_derivative", vec![f(32.0), u(4), f(0.5), u(3)]),
    ];
    let step = 0.02;
    for (plain, derivative, arguments) in cases {
        let here: Vec<Place> = places(4).into_iter().take(2000).collect();
        let exact = all_at_places(derivative, &here, &arguments);
        let values = at_places(plain, &here, &arguments);
        assert!(exact.iter().zip(&values).all(|(exact, value)| (exact[0] - value).abs() < 1e-5), "{plain}: values");
        for axis in [0, 2] {
            let side = |sign: f32| {
                let moved = here.iter().map(|at| {
                    let mut moved = *at;
                    moved.local[axis] += sign * step;
                    moved
                });
                at_places(plain, &moved.collect::<Vec<_>>(), &arguments)
            };
            let rises = side(1.0).into_iter().zip(side(-1.0)).map(|(after, before)| (after - before) / (2.0 * step));
            let worst = rises.zip(&exact).map(|(rise, exact)| (rise - exact[1 + axis / 2]).abs()).fold(0.0, f32::max);
            assert!(worst < 2e-3, "{derivative}: slope off by {worst} per metre on axis {axis}");
        }
    }
}

/// Jarzynski and Olano's pcg3d, written down a second time.
fn pcg3d(key: [u32; 3]) -> [u32; 3] {
    let mut v = key.map(|word| word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    for round in 0..2 {
        v[0] = v[0].wrapping_add(v[1].wrapping_mul(v[2]));
        v[1] = v[1].wrapping_add(v[2].wrapping_mul(v[0]));
        v[2] = v[2].wrapping_add(v[0].wrapping_mul(v[1]));
        if round == 0 {
            v = v.map(|word| word ^ (word >> 16));
        }
    }
    v
}

/// Distances to the nearest two of the points of so many cells around, in wavelengths, and the nearest one's number.
fn nearest_points(cell: [i64; 2], inside: [f64; 2], seed: u32, around: i64) -> [f64; 3] {
    let unit = |bits: u32| f64::from(bits >> 8) / f64::from(1 << 24);
    let mut found = Vec::new();
    for z in -around..=around {
        for x in -around..=around {
            let random = pcg3d([(cell[0] + x) as u32, (cell[1] + z) as u32, seed]);
            let away =
                |axis: usize, offset: i64| offset as f64 + 0.5 + (unit(random[axis]) - 0.5) * 0.656 - inside[axis];
            found.push((away(0, x).hypot(away(1, z)), unit(random[2])));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    [found[0].0, found[1].0, found[0].1]
}

/// Nine cells are enough: the same distances as from a search over 81.
#[test]
fn worley_finds_the_nearest_points() {
    let here: Vec<Place> = places(5).into_iter().take(5000).collect();
    let found = all_at_places("worley", &here, &[f(4.0), f(1.0), u(9)]);
    for (at, found) in here.iter().zip(found) {
        let units = [0, 1].map(|axis| f64::from(at.origin[axis]) / 1024.0 + f64::from(at.local[2 * axis]) / 4.0);
        let cell = units.map(|x| x.floor() as i64);
        let expected = nearest_points(cell, units.map(|x| x - x.floor()), 9, 4);
        for (found, expected) in found.iter().zip(expected) {
            assert!((f64::from(*found) - expected).abs() < 1e-5, "{at:?}: {found}, not {expected}");
        }
    }
}
