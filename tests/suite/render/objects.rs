//! What solids hide of the sky, on the machine against a sum over directions.

use std::f64::consts::TAU;

use glam::DVec3;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use terrane_codegen::machine::{F32, Machine, NoTextures, Value};
use terrane_shaderlib::hosts;

use super::world::{GREY, OUT, shader_in};

/// What a function of the host gives for some numbers and vectors.
fn call(function: &str, arguments: &[&[f64]]) -> Vec<f64> {
    let text = shader_in(hosts::WGPU_TERRAIN_FURNISHED, &format!("{OUT}{GREY}"));
    let module = naga::front::wgsl::parse_str(&text).expect("the device takes it");
    let info = Validator::new(ValidationFlags::all(), Capabilities::all()).validate(&module);
    let machine = Machine::new(&module, info.as_ref().expect("the device takes it"), &NoTextures);
    let value = |parts: &&[f64]| Value::<F32>::join(parts.iter().map(|part| Value::f32(&[*part as f32])));
    let arguments: Vec<Value<F32>> = arguments.iter().map(value).collect();
    let (found, _) = machine.call(function, &arguments, 1).unwrap_or_else(|error| panic!("{function}: {error}"));
    (0..found.components.len()).map(|part| found.float_at(part, 0).expect("all are floats").into()).collect()
}

/// Directions between the horizon and the zenith, and around it.
const DIRECTIONS: [u32; 2] = [400, 1600];

/// (1/π) ∫ ω dω over the directions of the upper hemisphere that hit something, whose border goes through about two of
/// a hundred cells of equal solid angle; those are wrong by half a cell either way.
fn summed(hits: impl Fn(DVec3) -> bool) -> DVec3 {
    let [rows, columns] = DIRECTIONS.map(f64::from);
    let direction = |index: u32| {
        let up = (f64::from(index / DIRECTIONS[1]) + 0.5) / rows;
        let (sin, cos) = ((f64::from(index % DIRECTIONS[1]) + 0.5) / columns * TAU).sin_cos();
        let flat = (1.0 - up * up).sqrt();
        DVec3::new(flat * cos, up, flat * sin)
    };
    let all = (0..DIRECTIONS[0] * DIRECTIONS[1]).map(direction);
    all.filter(|way| hits(*way)).sum::<DVec3>() * (2.0 / (rows * columns))
}

/// Where a line lies between two planes across an axis, as the first and the last t.
fn between(from: f64, way: f64, half: f64) -> (f64, f64) {
    let (a, b) = ((from - half) / way, (from + half) / way);
    (a.min(b), a.max(b))
}

#[track_caller]
fn expect_near(what: &str, found: DVec3, truth: DVec3, tolerance: f64) {
    assert!((found - truth).abs().max_element() < tolerance, "{what}: {found}, the sum is {truth}");
}

#[test]
fn what_a_sphere_hides_is_what_its_directions_sum_up_to() {
    for (up, far) in [(0.3, 1.2), (0.0, 1.01), (0.0, 2.0), (-0.2, 1.5), (0.9, 1.5), (0.5, 3.0), (-0.5, 1.2)] {
        let middle = DVec3::new(f64::sqrt(1.0 - up * up), up, 0.0);
        let edge = f64::sqrt(1.0 - 1.0 / (far * far));
        let truth = summed(|way| way.dot(middle) > edge).y;
        let found = call("host_hidden_sphere", &[&[up], &[far]])[0];
        assert!((found - truth).abs() < 2e-3, "{up}, {far}: {found}, the sum is {truth}");
    }
}

#[test]
fn what_a_box_hides_is_what_its_directions_sum_up_to() {
    let half = DVec3::new(0.5, 0.3, 0.2);
    // Beside a side, before an edge, far away, under it, over a corner of its foot.
    let places = [[0.7, 0.3, 0.0], [0.8, 0.3, 0.6], [3.0, 0.3, -2.0], [0.1, 0.8, 0.05], [-0.6, 0.5, 0.3]];
    for to in places.map(DVec3::from) {
        let truth = summed(|way| {
            let slabs = [0, 1, 2].map(|axis| between(to[axis], way[axis], half[axis]));
            let (enter, leave) =
                slabs.iter().fold((0.0, f64::INFINITY), |(a, b), slab| (f64::max(a, slab.0), f64::min(b, slab.1)));
            enter < leave
        });
        let found = DVec3::from_slice(&call("host_hidden_box", &[&to.to_array(), &half.to_array()]));
        expect_near(&format!("{to}"), found, truth, 2e-3);
    }
}

#[test]
fn what_a_column_hides_is_nearly_what_its_directions_sum_up_to() {
    let half = DVec3::new(0.3, 0.8, 0.3);
    for to in [[0.35, 0.8, 0.0], [0.4, 0.8, 0.4], [-2.0, 0.8, 1.0]].map(DVec3::from) {
        let truth = summed(|way| {
            let flat = way.x.hypot(way.z).max(1e-9);
            let (along, aside) = ((to.x * way.x + to.z * way.z) / flat, (to.x * way.z - to.z * way.x) / flat);
            // The rim of its top where the direction meets its side.
            let chord = 0.3 * 0.3 - aside * aside;
            chord > 0.0 && along > 0.0 && way.y / flat * (along - chord.sqrt()) < to.y + half.y
        });
        let found = DVec3::from_slice(&call("host_hidden_column", &[&to.to_array(), &half.to_array()]));
        // Its top is taken for a straight edge, which it is not.
        expect_near(&format!("{to}"), found, truth, 0.02);
    }
}
