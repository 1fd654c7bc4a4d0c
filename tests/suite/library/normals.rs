//! Normals belong to their heights: what a normal map says is the slope of the heights that were laid on the same way.

use std::f64::consts::TAU;

use terrane_codegen::machine::{Count, F32, Load, Machine, Sample, Textures, Value};

use super::LIBRARY;
use super::call::{Place, floats, place};

/// Metres of a tile, and the height of the bumps' white: 1 m.
const TILE: f32 = 4.0;

/// A normal map in red, green and blue whose heights are in alpha.
struct Bumps;

impl Textures for Bumps {
    fn sample(&self, sample: &Sample) -> Option<[f64; 4]> {
        let [u, v] = sample.uv.map(|coordinate| coordinate * TAU);
        let height = 0.5 + 0.1 * u.sin() + 0.07 * (2.0 * v + u).cos();
        let slope = [0.1 * u.cos() - 0.07 * (2.0 * v + u).sin(), -0.14 * (2.0 * v + u).sin()];
        let [x, y] = slope.map(|rise| -rise * TAU / f64::from(TILE));
        let length = (x * x + y * y + 1.0).sqrt();
        Some([0.5 + 0.5 * x / length, 0.5 + 0.5 * y / length, 0.5 + 0.5 / length, height])
    }
    fn load(&self, _: &Load) -> Option<[f64; 4]> {
        None
    }
    fn size(&self, _: u32, _: u32) -> Option<[u32; 2]> {
        Some([256, 256])
    }
    fn count(&self, _: u32) -> Option<Count> {
        Some(Count { layers: 1, levels: 1 })
    }
}

/// The same bumps as a height texture.
struct Heights;

impl Textures for Heights {
    fn sample(&self, sample: &Sample) -> Option<[f64; 4]> {
        Bumps.sample(sample).map(|texel| [texel[3]; 4])
    }
    fn load(&self, _: &Load) -> Option<[f64; 4]> {
        None
    }
    fn size(&self, texture: u32, level: u32) -> Option<[u32; 2]> {
        Bumps.size(texture, level)
    }
    fn count(&self, texture: u32) -> Option<Count> {
        Bumps.count(texture)
    }
}

fn call(function: &str, arguments: &[Value<F32>], points: usize) -> Vec<Vec<f32>> {
    call_with(&Bumps, function, arguments, points)
}

fn call_with(textures: &dyn Textures, function: &str, arguments: &[Value<F32>], points: usize) -> Vec<Vec<f32>> {
    let machine = Machine::new(&LIBRARY.module, &LIBRARY.info, textures);
    let (value, _) = machine.call(function, arguments, points).unwrap_or_else(|error| panic!("{function}: {error}"));
    floats(&value, points)
}

fn sample(function: &str, places: &[Place], rest: &[Value<F32>]) -> Vec<Vec<f32>> {
    let texture = [Value::handle(0), Value::handle(0), Value::i32(&[0]), place(places)];
    call(function, &[&texture, rest].concat(), places.len())
}

/// Rise of a node's heights per metre along an axis.
fn rise(function: &str, places: &[Place], rest: &[Value<F32>], axis: usize) -> Vec<f32> {
    let step = 0.01;
    let side = |sign: f32| {
        let moved = places.iter().map(|at| {
            let mut moved = *at;
            moved.local[axis] += sign * step;
            moved
        });
        sample(function, &moved.collect::<Vec<_>>(), rest)
    };
    side(1.0).iter().zip(side(-1.0)).map(|(after, before)| (after[3] - before[3]) / (2.0 * step)).collect()
}

fn f(value: f32) -> Value<F32> {
    Value::f32(&[value])
}

/// On the grid's own points one copy stands alone, turned and shifted as it is.
#[test]
fn hexagonal_copies_turn_their_normals_back() {
    // 0.7 tiles are 717 units between points of a row.
    let points: Vec<Place> = (0..200).map(|k| Place::new([(k - 100) * 717, 0], 0.0, 0.0)).collect();
    let rest = [f(TILE), f(0.7), f(1.0), Value::u32(&[3])];
    let normals = sample("hex_tile_normal", &points, &[&rest[..], &[f(1.0)]].concat());
    for (axis, component) in [(0, 0), (2, 1)] {
        let rises = rise("hex_tile", &points, &rest, axis);
        for (normal, rise) in normals.iter().zip(rises) {
            let tilt = normal[component] / normal[2];
            assert!((tilt + rise).abs() < 2e-3, "tilt {tilt}, rise {rise}, axis {axis}");
        }
    }
}

/// Every view bends the normal against the slope that its own view of the heights has.
#[test]
fn triplanar_normals_follow_their_heights() {
    let points: Vec<Place> = (0..100)
        .map(|k| Place { local: [0.37 * k as f32, 0.23 * k as f32, 0.11 * k as f32], ..Place::default() })
        .collect();
    for ground in [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]] {
        let normal = Value::vector(&[ground]);
        let rest = [normal.clone(), f(TILE), f(4.0)];
        let bent = sample("triplanar_normal", &points, &[&rest[..], &[f(1.0)]].concat());
        let bent: Vec<[f32; 3]> = bent.into_iter().map(|n| [n[0], n[1], n[2]]).collect();
        let world = call("normal_to_world", &[Value::vector(&bent), normal], points.len());
        for axis in 0..3 {
            let along = ground[axis] != 0.0;
            for (world, rise) in world.iter().zip(rise("triplanar", &points, &rest, axis)) {
                let outward: f32 = world.iter().zip(ground).map(|(n, g)| n * g).sum();
                let tilt = world[axis] / outward;
                let expected = if along { ground[axis] } else { -rise };
                assert!((tilt - expected).abs() < 2e-3, "{ground:?}, axis {axis}: {tilt}, not {expected}");
            }
        }
    }
}

/// Four and eight samples of the heights give what the map says.
#[test]
fn normals_made_from_heights_are_those_of_the_map() {
    let points: Vec<[f32; 2]> = (0..200).map(|k| [0.0925 * k as f32, 0.0275 * k as f32]).collect();
    let uv = Value::join([Value::vector(&points), Value::vector(&[[0.0; 2]]), Value::vector(&[[0.0; 2]])]);
    let texture = [Value::handle(0), Value::handle(0), Value::i32(&[0]), uv];
    let texels = call("texture", &texture, points.len());
    let texels: Vec<[f32; 4]> = texels.into_iter().map(|texel| [texel[0], texel[1], texel[2], texel[3]]).collect();
    let expected = call("normal_map", &[Value::vector(&texels), f(1.0), f(0.0)], points.len());
    for function in ["normal_from_height", "normal_sobel"] {
        let made = call_with(&Heights, function, &[&texture[..], &[f(1.0), f(TILE)]].concat(), points.len());
        for (made, expected) in made.iter().flatten().zip(expected.iter().flatten()) {
            // A texel of 1/256 tile smooths bumps of half a tile by (2 pi / 128)^2 / 6.
            assert!((made - expected).abs() < 1e-3, "{function}: {made}, not {expected}");
        }
    }
}
