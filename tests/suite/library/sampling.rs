//! Nodes that read textures: no seam between copies or patches, and no repetition where none is promised.

use terrane_codegen::machine::{F32, Value};

use super::call::{Place, floats, machine, place};
use super::ranges::Random;

const POINTS: usize = 4000;

fn f(value: f32) -> Value<F32> {
    Value::f32(&[value])
}

/// A node that takes a texture, a place and further arguments.
fn sample(function: &str, places: &[Place], rest: &[Value<F32>]) -> Vec<Vec<f32>> {
    let texture = [Value::handle(0), Value::handle(0), Value::i32(&[0]), place(places)];
    let arguments: Vec<Value<F32>> = texture.into_iter().chain(rest.iter().cloned()).collect();
    let called = machine().call(function, &arguments, places.len());
    floats(&called.unwrap_or_else(|error| panic!("{function}: {error}")).0, places.len())
}

fn cases() -> Vec<(&'static str, Vec<Value<F32>>)> {
    let hex = || vec![f(4.0), f(0.7), f(1.0), Value::u32(&[3])];
    let ground = || Value::vector(&[[0.5, 0.7, 0.51]]);
    vec![
        ("hex_tile", hex()),
        ("hex_tile_normal", [hex(), vec![f(0.5)]].concat()),
        ("triplanar", vec![ground(), f(4.0), f(4.0)]),
        ("triplanar_normal", vec![ground(), f(4.0), f(4.0), f(0.5)]),
    ]
}

fn places(seed: u64) -> Vec<Place> {
    let mut random = Random(seed);
    let mut one = |_| {
        let origin = [0; 2].map(|_| random.between(-30_000_000.0, 30_000_000.0) as i32);
        let [x, y, z] = [0.0; 3].map(|_: f64| random.between(0.0, 64.0) as f32);
        Place { origin, local: [x, y, z], ..Place::default() }
    };
    (0..POINTS).map(&mut one).collect()
}

fn worst(a: Vec<Vec<f32>>, b: Vec<Vec<f32>>) -> f32 {
    let differences = a.into_iter().flatten().zip(b.into_iter().flatten()).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f32::max)
}

fn moved(places: &[Place], x: f32, z: f32, origin: [i32; 2]) -> Vec<Place> {
    let local = |at: &Place| [at.local[0] + x, at.local[1], at.local[2] + z];
    let corner = |at: &Place| [at.origin[0] + origin[0], at.origin[1] + origin[1]];
    places.iter().map(|at| Place { origin: corner(at), local: local(at), ..*at }).collect()
}

#[test]
fn samples_are_continuous() {
    for (function, rest) in cases() {
        let here = places(1);
        for (x, z) in [(1e-4, 0.0), (0.0, 1e-4), (1e-4, -1e-4)] {
            let jump = worst(sample(function, &here, &rest), sample(function, &moved(&here, x, z, [0; 2]), &rest));
            assert!(jump < 0.01, "{function}: {jump} over 0.1 mm");
        }
    }
}

#[test]
fn samples_meet_between_patches() {
    for (function, rest) in cases() {
        let here = places(2);
        let there = moved(&here, -64.0, 64.0, [64 * 256, -64 * 256]);
        let jump = worst(sample(function, &here, &rest), sample(function, &there, &rest));
        assert!(jump < 0.01, "{function}: {jump} between patches");
    }
}

#[test]
fn hexagonal_tiling_does_not_repeat() {
    let rest = &cases()[0].1;
    let here = places(3);
    let red = |places: &[Place]| sample("hex_tile", places, rest).into_iter().map(|color| color[0]).collect::<Vec<_>>();
    let values = red(&here);
    let mean = |values: &[f32]| values.iter().sum::<f32>() / values.len() as f32;
    let middle = mean(&values);
    let spread = mean(&values.iter().map(|x| (x - middle).powi(2)).collect::<Vec<_>>());
    for tiles in 1..8 {
        let other = red(&moved(&here, 0.0, 0.0, [1024 * tiles, 0]));
        let product = mean(&values.iter().zip(&other).map(|(a, b)| (a - middle) * (b - middle)).collect::<Vec<_>>());
        assert!((product / spread).abs() < 0.1, "{tiles} tiles away the texture correlates by {}", product / spread);
    }
}
