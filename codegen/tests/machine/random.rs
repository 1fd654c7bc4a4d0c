//! Random programs: lanes against one point at a time, and both precisions against `Accept`.

mod program;

use terrane_codegen::machine::domain::accept::Interval;
use terrane_codegen::machine::{Accept, Component, F32, F64, Value};

use crate::support::{Random, Shader, shader};

/// Enough to find every mistake that was planted; 2,000 once found no more.
const PROGRAMS: u32 = 80;
const POINTS: usize = 40;

/// One program and the points that it is run at.
struct Case {
    text: String,
    shader: Shader,
    a: Vec<f32>,
    b: Vec<f32>,
    n: Vec<u32>,
}

impl Case {
    fn new(seed: u32) -> Self {
        let text = program::write(seed);
        let shader = shader(&text);
        let mut random = Random::new(seed ^ 0x5eed);
        // Tenths, so that rounding matters; conditions compare with them.
        let mut draw = || (0..POINTS).map(|_| (random.below(80) as f32 - 40.0) / 10.0).collect();
        let (a, b) = (draw(), draw());
        let n = (0..POINTS).map(|_| random.below(9)).collect();
        Self { text, shader, a, b, n }
    }
}

fn same(a: &Component<F32>, b: &Component<F32>, point: usize) -> bool {
    match (a, b) {
        (Component::Float(a), Component::Float(b)) => {
            let (a, b) = (a[point.min(a.len() - 1)], b[0]);
            a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
        }
        _ => false,
    }
}

#[test]
fn the_value_of_a_lane_does_not_depend_on_the_others() {
    for seed in 0..PROGRAMS {
        let case = Case::new(seed);
        let arguments = [Value::f32(&case.a), Value::f32(&case.b), Value::u32(&case.n)];
        let mut machine = case.shader.machine();
        let (together, counts) = machine.call::<F32>("program", &arguments, POINTS).expect("it runs");
        machine.set_chunk(7);
        let (chunked, chunked_counts) = machine.call::<F32>("program", &arguments, POINTS).expect("it runs");
        let mut alone_counts = terrane_codegen::machine::Counts::default();
        for point in 0..POINTS {
            let arguments = [Value::f32(&[case.a[point]]), Value::f32(&[case.b[point]]), Value::u32(&[case.n[point]])];
            let (alone, counts) = machine.call::<F32>("program", &arguments, 1).expect("it runs");
            alone_counts += counts;
            for i in 0..alone.components.len() {
                for lanes in [&together, &chunked] {
                    assert!(
                        same(&lanes.components[i], &alone.components[i], point),
                        "seed {seed}, point {point}, component {i}\n{}",
                        case.text
                    );
                }
            }
        }
        assert_eq!(counts, alone_counts, "seed {seed}\n{}", case.text);
        assert_eq!(counts, chunked_counts, "seed {seed}\n{}", case.text);
    }
}

#[test]
fn both_precisions_are_accepted() {
    let mut bounded = 0;
    for seed in 0..PROGRAMS {
        let case = Case::new(seed);
        let single = case.shader.call::<F32>("program", &arguments(&case.a, &case), POINTS);
        let double = case.shader.call::<F64>(
            "program",
            &[Value::f32(&case.a), Value::f32(&case.b), Value::u32(&case.n)],
            POINTS,
        );
        let accepted = case.shader.call::<Accept>(
            "program",
            &[Value::f32(&case.a), Value::f32(&case.b), Value::u32(&case.n)],
            POINTS,
        );
        for (i, point) in (0..single.components.len()).flat_map(|i| (0..POINTS).map(move |point| (i, point))) {
            let (single, double) = (single.float_at(i, point).expect("f32"), double.float_at(i, point).expect("f64"));
            let accepted = accepted.float_at(i, point).expect("an interval");
            let what = || format!("seed {seed}, point {point}, component {i}, {accepted:?}\n{}", case.text);
            assert!(accepted.accepts(single), "{single} in {}", what());
            assert!(accepted.holds(double), "{double} in {}", what());
            bounded += u32::from(!accepted.is_unbounded());
        }
    }
    let all = PROGRAMS * POINTS as u32 * 4;
    assert!(bounded > all / 2, "only {bounded} of {all} results have bounds, which tests little");
}

fn arguments(a: &[f32], case: &Case) -> [Value<F32>; 3] {
    [Value::f32(a), Value::f32(&case.b), Value::u32(&case.n)]
}

/// Intervals of arguments leave conditions open: what each argument inside gives must be accepted.
#[test]
fn results_of_all_arguments_in_an_interval_are_accepted() {
    let mut bounded = 0;
    for seed in 0..PROGRAMS {
        let case = Case::new(seed);
        let wide: Vec<Interval> = case.a.iter().map(|a| Interval::new(a - 0.3, a + 0.3)).collect();
        let wide = Value { components: vec![Component::Float(wide)] };
        let accepted = case.shader.call::<Accept>("program", &[wide, Value::f32(&case.b), Value::u32(&case.n)], POINTS);
        for step in -3..=3 {
            let inside: Vec<f32> = case.a.iter().map(|a| a + step as f32 / 10.0).map(|a| a.clamp(a, a)).collect();
            let single = case.shader.call::<F32>("program", &arguments(&inside, &case), POINTS);
            for (i, point) in (0..single.components.len()).flat_map(|i| (0..POINTS).map(move |point| (i, point))) {
                let (single, accepted) =
                    (single.float_at(i, point).expect("f32"), accepted.float_at(i, point).expect("an interval"));
                let (a, b, n) = (inside[point], case.b[point], case.n[point]);
                let what = || format!("seed {seed}, a {a}, b {b}, n {n}, component {i}, {accepted:?}\n{}", case.text);
                assert!(accepted.accepts(single), "{single} in {}", what());
                bounded += u32::from(!accepted.is_unbounded());
            }
        }
    }
    let all = PROGRAMS * POINTS as u32 * 4 * 7;
    assert!(bounded > all / 4, "only {bounded} of {all} results have bounds, which tests little");
}
