//! Probes: valid shaders, and judgement of their results.

use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;
use terrane_codegen::machine::probe::Resource;
use terrane_codegen::machine::{Accept, F32, Machine, NoTextures, Probe, Value};

use crate::support::shader;

#[test]
fn every_node_has_a_valid_probe() {
    let library = Library::load(&mut Sources::default(), &[]).expect("the shipped library is right");
    for overload in library.kinds.values().flat_map(|kind| &kind.overloads) {
        let probe = Probe::new(&library, &overload.function).expect("nodes are made of numbers");
        let checked = shader(&probe.shader);
        assert_eq!(checked.module.entry_points.len(), 1, "{}", overload.function);
        assert!(probe.outputs > 0, "{}", overload.function);
    }
}

const MIXED: &str = "
struct Mixed { a: vec2i, b: array<f32, 2>, c: bool }
struct Result { m: mat2x2f, n: u32, o: Inner }
struct Inner { p: vec2<bool>, q: array<i32, 2> }
fn mixed(x: Mixed, t: texture_2d_array<f32>, s: sampler, k: mat2x3f, z: u32) -> Result {
    let sum = x.b[0] + k[1].z / 3.0;
    let inner = Inner(vec2<bool>(x.c, z > 4u), array(x.a.y, x.a.x));
    return Result(mat2x2f(1.0, sum, k[0].y, k[1].x), z + 1u, inner);
}";

#[test]
fn words_follow_the_order_of_the_scalars() {
    let mixed = shader(MIXED);
    let probe = Probe::of_module(&mixed.module, MIXED, "mixed").expect("it is made of numbers");
    assert_eq!((probe.inputs, probe.outputs), (12, 9));
    assert_eq!(probe.resources, [Resource::Texture, Resource::Sampler]);
    shader(&probe.shader);
    assert!(probe.shader.contains(
        "mixed(Mixed(vec2<i32>(bitcast<i32>(probe_arguments[first + 0u]), bitcast<i32>(probe_arguments[first + 1u])), \
         array(f32(bitcast<f32>(probe_arguments[first + 2u])), f32(bitcast<f32>(probe_arguments[first + 3u]))), \
         bool(probe_arguments[first + 4u] != 0u)), probe_resource_1, probe_resource_2, mat2x3<f32>("
    ));
    assert!(probe.shader.contains("probe_results[id.x * 9u + 1u] = bitcast<u32>(result.m[0][1]);"));
    assert!(probe.shader.contains("probe_results[id.x * 9u + 6u] = u32(result.o.p[1]);"));
    let arguments = arguments();
    let words = probe.words(&arguments, 2);
    assert_eq!(words.len(), 24);
    assert_eq!(words[..5], [-3_i32 as u32, 4, 0.5_f32.to_bits(), 1.0_f32.to_bits(), 1]);
    assert_eq!(words[12..17], [5, 4, 0.5_f32.to_bits(), 2.0_f32.to_bits(), 1]);
    assert_eq!([words[11], words[23]], [4, 5]);
}

fn arguments() -> Vec<Value<F32>> {
    let mixed = Value::join([
        Value::integers(&[[-3, 4], [5, 4]]),
        Value::vector(&[[0.5, 1.0], [0.5, 2.0]]),
        Value::bool(&[true]),
    ]);
    let matrix = Value::join((1..=6).map(|i| Value::f32(&[i as f32])));
    vec![mixed, Value::handle(0), Value::handle(0), matrix, Value::u32(&[4, 5])]
}

#[test]
fn right_results_are_accepted_and_wrong_ones_are_not() {
    let mixed = shader(MIXED);
    let probe = Probe::of_module(&mixed.module, MIXED, "mixed").expect("it is made of numbers");
    let machine = Machine::new(&mixed.module, &mixed.info, &NoTextures);
    let (result, _) = machine.call("mixed", &arguments(), 2).expect("it runs");
    let right = probe.words(&[result], 2);
    let verdict = probe.judge(&machine, &arguments(), 2, &right).expect("it runs");
    assert_eq!((verdict.words, verdict.unbounded), (18, 0));
    assert_eq!(verdict.rejected, []);
    for word in 0..right.len() {
        let mut wrong = right.clone();
        // Far enough from a quotient that has 2.5 units of freedom.
        wrong[word] ^= if word % 9 < 4 { 16 } else { 1 };
        let verdict = probe.judge(&machine, &arguments(), 2, &wrong).expect("it runs");
        let places: Vec<_> = verdict.rejected.iter().map(|wrong| wrong.point * 9 + wrong.component).collect();
        assert_eq!(places, [word], "word {word}");
    }
    let mut wrong = right;
    wrong[1] = 9.0_f32.to_bits();
    let verdict = probe.judge(&machine, &arguments(), 2, &wrong).expect("it runs");
    assert_eq!(verdict.rejected[0].to_string(), "point 0, component 1: 9.0 is not in 2.4999995 ..= 2.5000005");
}

#[test]
fn arguments_convert_to_other_domains() {
    let value: Value<Accept> = arguments()[0].to();
    assert_eq!(value.float_at(2, 1).map(|interval| (interval.low(), interval.high())), Some((0.5, 0.5)));
    assert_eq!(
        value.int_at(0, 0).and_then(|integers| integers.values().map(<[u32]>::to_vec)),
        Some(vec![-3_i32 as u32])
    );
}
