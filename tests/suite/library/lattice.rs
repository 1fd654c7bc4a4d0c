//! Grids and texture coordinates against whole-number arithmetic, up to 8,000 km from the corner.

use terrane_codegen::machine::{F32, Value};

use super::call::{Place, all_at_places, at_places, machine, place};
use super::ranges::Random;

const POINTS: usize = 4000;

fn far_places(seed: u64) -> Vec<Place> {
    let mut random = Random(seed);
    let mut coordinate = || random.between(-2.048e9, 2.048e9) as i32;
    let origins: Vec<[i32; 2]> = (0..POINTS).map(|_| [coordinate(), coordinate()]).collect();
    let mut along = || random.between(-64.0, 4096.0) as f32;
    origins.into_iter().map(|origin| Place::new(origin, along(), along())).collect()
}

/// Cell and fraction along one axis: the definition, in numbers that are large enough.
fn reference(origin: i32, local: f32, wavelength: f32) -> (i64, f64) {
    let period = (f64::from(wavelength) * 256.0).round_ties_even().clamp(1.0, 4_194_304.0);
    // The origin is whole and the period too: the division is exact in i64, the local part in f64.
    let (cells, rest) = (i64::from(origin).div_euclid(period as i64), i64::from(origin).rem_euclid(period as i64));
    let along = (rest as f64 + f64::from(local) * 256.0) / period;
    (cells + along.floor() as i64, along - along.floor())
}

#[test]
fn cells_are_exact_wherever_the_patch_is() {
    for wavelength in [0.01, 0.25, 1.0, 3.3, 64.0, 777.7, 16384.0] {
        let places = far_places(7);
        let arguments = [place(&places), Value::f32(&[wavelength])];
        let (lattice, _) = machine().call::<F32>("place_lattice", &arguments, POINTS).expect("place_lattice runs");
        for (point, at) in places.iter().enumerate() {
            for axis in [0, 1] {
                let (cell, fraction) = reference(at.origin[axis], at.local[2 * axis], wavelength);
                let found = i64::from(lattice.int_at(axis, point).expect("a cell") as i32);
                let inside = f64::from(lattice.float_at(2 + axis, point).expect("a fraction"));
                let off = (found - cell) as f64 + inside - fraction;
                assert!((0.0..1.0).contains(&inside), "{at:?} {wavelength}: fraction {inside}");
                assert!(off.abs() < 2e-6, "{at:?} {wavelength}: off by {off} cells");
            }
        }
    }
}

#[test]
fn whole_periods_change_the_cell_and_nothing_else() {
    let near: Vec<Place> =
        far_places(3).into_iter().map(|at| Place { origin: at.origin.map(|x| x / 4), ..at }).collect();
    // 1,000,000 m are 125,000 periods of 8 m.
    let far: Vec<Place> = near.iter().map(|at| Place { origin: at.origin.map(|x| x + 256_000_000), ..*at }).collect();
    let fractions = |places: &[Place]| all_at_places("place_lattice", places, &[Value::f32(&[8.0])]);
    assert_eq!(fractions(&near), fractions(&far));
    let coordinates = |places: &[Place]| all_at_places("place_coord", places, &[Value::f32(&[8.0])]);
    assert_eq!(coordinates(&near), coordinates(&far));
}

/// The same point of the ground, seen from the patch east of it.
fn from_the_next_patch(at: &Place) -> Place {
    Place {
        origin: [at.origin[0] + 64 * 256, at.origin[1]],
        local: [at.local[0] - 64.0, at.local[1], at.local[2]],
        ..*at
    }
}

#[test]
fn patches_meet_without_a_seam() {
    let mut random = Random(11);
    let mut here = |_| {
        let origin = [0; 2].map(|_| (random.between(-120_000.0, 120_000.0) as i32) * 64 * 256);
        Place::new(origin, 64.0, random.between(0.0, 64.0) as f32)
    };
    let here: Vec<Place> = (0..POINTS).map(&mut here).collect();
    let there: Vec<Place> = here.iter().map(from_the_next_patch).collect();
    let seed = || Value::u32(&[5]);
    let f = |value: f32| Value::f32(&[value]);
    let cases = [
        ("gradient_noise", vec![f(3.7), seed()]),
        ("value_noise", vec![f(0.9), seed()]),
        ("fbm", vec![f(100.0), Value::u32(&[8]), f(0.5), seed()]),
        ("ridged", vec![f(50.0), Value::u32(&[5]), f(0.5), f(2.0), seed()]),
        ("worley", vec![f(2.5), f(1.0), seed()]),
        ("cracks", vec![f(2.5), f(0.2), f(1.0), seed()]),
        ("stripes", vec![f(0.7), f(33.0)]),
    ];
    for (function, rest) in cases {
        let differences = at_places(function, &here, &rest).into_iter().zip(at_places(function, &there, &rest));
        let worst = differences.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(worst < 3e-3, "{function}: {worst}");
    }
}

#[test]
fn turned_coordinates_meet_without_a_seam() {
    let here: Vec<Place> =
        far_places(23).iter().map(|at| Place { local: [64.0, 0.0, at.local[2] / 64.0], ..*at }).collect();
    let there: Vec<Place> = here.iter().map(from_the_next_patch).collect();
    for angle in [0.0, 30.0, 90.0, 123.4, -77.0] {
        let rest = [Value::f32(&[3.3]), Value::f32(&[angle])];
        let uv = |places: &[Place]| all_at_places("rotated", places, &rest);
        for (a, b) in uv(&here).into_iter().zip(uv(&there)) {
            for axis in [0, 1] {
                // Two tiles are one turn of the phase.
                let apart = f64::from(a[axis] - b[axis]) / 2.0;
                assert!((apart - apart.round()).abs() < 1e-4, "{angle}: {a:?} {b:?}");
            }
        }
    }
}
