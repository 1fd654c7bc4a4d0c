//! `Accept` holds what it must, and not much more.

use terrane_codegen::machine::domain::accept::{Integers, Interval};
use terrane_codegen::machine::domain::{Accept, Domain, F32, F64, FloatBinary, FloatTernary, FloatUnary, IntBinary};

use crate::support::{Random, floats};

#[track_caller]
fn holds(interval: Interval, single: f32, double: f64, what: impl Fn() -> String) {
    // What is not finite has no bounds in WGSL.
    if double.is_finite() {
        assert!(interval.holds(double), "{}: {double:e} is not in {interval:?}", what());
    } else {
        assert!(interval.is_unbounded(), "{}: {double} and {interval:?}", what());
    }
    if single.is_finite() {
        assert!(interval.accepts(single), "{}: {single:e} is not in {interval:?}", what());
    }
}

#[test]
fn unary_results_of_both_precisions_are_accepted() {
    for x in floats(262_147).filter(|x| x.is_finite()) {
        let interval = Accept::float(x);
        for op in FloatUnary::ALL {
            let (single, double) = (F32::float_unary(*op, x), F64::float_unary(*op, f64::from(x)));
            holds(Accept::float_unary(*op, interval), single, double, || format!("{op:?} of {x:e}"));
        }
    }
}

#[test]
fn results_inside_an_interval_of_arguments_are_accepted() {
    let mut random = Random::new(1);
    for _ in 0..20_000 {
        let (a, b) = (random.float(), random.float());
        let (low, high) = (a.min(b), a.max(b));
        let interval = Interval::new(low, high);
        let inside = |t: f32| (low * (1.0 - t) + high * t).clamp(low, high);
        for x in [low, high, inside(0.5), inside(random.unit()), inside(0.001 * random.unit())] {
            for op in FloatUnary::ALL {
                let (single, double) = (F32::float_unary(*op, x), F64::float_unary(*op, f64::from(x)));
                holds(Accept::float_unary(*op, interval), single, double, || format!("{op:?} of {x} in {interval:?}"));
            }
        }
    }
}

#[test]
fn binary_and_ternary_results_are_accepted() {
    let mut random = Random::new(2);
    for _ in 0..100_000 {
        let [a, b, c] = [random.float(), random.float(), random.float()];
        let [x, y, z] = [a, b, c].map(f64::from);
        let [p, q, r] = [a, b, c].map(Accept::float);
        for op in FloatBinary::ALL {
            let (single, double) = (F32::float_binary(*op, a, b), F64::float_binary(*op, x, y));
            holds(Accept::float_binary(*op, p, q), single, double, || format!("{op:?} of {a:e}, {b:e}"));
        }
        for op in FloatTernary::ALL {
            let (single, double) = (F32::float_ternary(*op, a, b, c), F64::float_ternary(*op, x, y, z));
            holds(Accept::float_ternary(*op, p, q, r), single, double, || format!("{op:?} of {a:e}, {b:e}, {c:e}"));
        }
    }
}

#[test]
fn sums_of_products_are_accepted_in_any_order() {
    let mut random = Random::new(3);
    for _ in 0..20_000 {
        let a = [0; 4].map(|_| random.float().clamp(-1e9, 1e9));
        let b = [0; 4].map(|_| random.float().clamp(-1e9, 1e9));
        let interval = Accept::dot(&a.map(Accept::float), &b.map(Accept::float));
        let product: [f32; 4] = std::array::from_fn(|i| a[i] * b[i]);
        let pairwise = (product[0] + product[3]) + (product[2] + product[1]);
        let fused = a[3].mul_add(b[3], a[1].mul_add(b[1], a[2].mul_add(b[2], product[0])));
        let exact = F64::dot(&a.map(f64::from), &b.map(f64::from));
        holds(interval, pairwise, exact, || format!("{a:?} . {b:?}"));
        holds(interval, fused, exact, || format!("{a:?} . {b:?}"));
        holds(interval, F32::dot(&a, &b), exact, || format!("{a:?} . {b:?}"));
    }
}

/// The table of WGSL 15.7.4.1, at a point each: widths in units of the last place or absolute.
#[test]
fn the_widths_are_those_of_the_accuracy_table() {
    let unit = f64::from(f32::EPSILON);
    let width = |interval: Interval| f64::from(interval.high()) - f64::from(interval.low());
    let of = |op, x| width(Accept::float_unary(op, Accept::float(x)));
    let two = |op, a, b| width(Accept::float_binary(op, Accept::float(a), Accept::float(b)));
    // A result between two floats may be either.
    assert_eq!(two(FloatBinary::Add, 1.0, 1e-9), unit);
    assert_eq!(two(FloatBinary::Add, 1.0, 0.5), 0.0);
    assert_eq!(two(FloatBinary::Multiply, 1.5, 3.0), 0.0);
    // 2.5 ULP on either side, then to the next float outward.
    assert_eq!(two(FloatBinary::Divide, 3.0, 2.0), 6.0 * unit);
    assert_eq!(of(FloatUnary::InverseSqrt, 0.5), 5.0 * unit);
    assert!((of(FloatUnary::Sin, 1.0) - 2.0_f64.powi(-10)).abs() < 1e-6);
    assert!((of(FloatUnary::Log, 1.5) - 2.0_f64.powi(-20)).abs() < 1e-6);
    assert!((of(FloatUnary::Exp, 0.25) - 7.0 * unit).abs() <= 2.0 * unit);
    assert!(of(FloatUnary::Sin, 4.0).is_infinite(), "no accuracy outside -pi..pi");
    assert!(two(FloatBinary::Divide, 1.0, 0.0).is_infinite());
    assert!(two(FloatBinary::Pow, -1.0, 2.0).is_infinite());
}

#[test]
fn integer_results_are_accepted_for_sets_and_ranges() {
    let mut random = Random::new(4);
    let set = |random: &mut Random| {
        let first = random.bits() >> (random.bits() % 32);
        let length = random.bits() % 20;
        let last = first.saturating_add(length);
        let pick = first + random.bits() % (last - first + 1);
        (Integers::range(first, last), pick)
    };
    for _ in 0..100_000 {
        let ((a, x), (b, y)) = (set(&mut random), set(&mut random));
        for op in IntBinary::ALL {
            let result = Accept::int_binary(*op, a, b);
            assert!(result.accepts(op.apply(x, y)), "{op:?} of {x}, {y} in {a:?}, {b:?}: {result:?}");
        }
        for op in terrane_codegen::machine::domain::IntComparison::ALL {
            if let Some(holds) = Accept::decide(Accept::int_comparison(*op, a, b)) {
                assert_eq!(holds, op.apply(x, y), "{op:?} of {x}, {y} in {a:?}, {b:?}");
            }
        }
    }
}

#[test]
fn conversions_are_accepted() {
    let mut random = Random::new(5);
    for _ in 0..200_000 {
        let x = random.float();
        let (interval, double) = (Accept::float(x), f64::from(x));
        for signed in [false, true] {
            let found = Accept::int_from_float(signed, interval);
            assert!(found.accepts(F32::int_from_float(signed, x)), "{x} to {found:?}");
            assert!(found.accepts(F64::int_from_float(signed, double)), "{x} to {found:?}");
        }
        let bits = random.bits();
        let integer = Accept::int(bits);
        for signed in [false, true] {
            let found = Accept::float_from_int(signed, integer);
            assert!(found.accepts(F32::float_from_int(signed, bits)), "{bits} to {found:?}");
            assert!(found.holds(F64::float_from_int(signed, bits)), "{bits} to {found:?}");
        }
        assert!(Accept::bits_from_float(interval).accepts(x.to_bits()), "bits of {x:e}");
        assert!(Accept::half_bits(interval).accepts(F32::half_bits(x)), "half of {x:e}");
        assert!(Accept::float_from_half(integer).accepts(F32::float_from_half(bits)), "half {bits:x}");
        assert!(Accept::exponent(interval).accepts(F32::exponent(x)), "exponent of {x:e}");
        let exponent = bits % 300;
        let scaled = F32::scale(x, exponent.wrapping_sub(150));
        let found = Accept::scale(interval, Accept::int(exponent.wrapping_sub(150)));
        assert!(found.accepts(scaled), "{x:e} * 2^{} is {scaled:e}: {found:?}", exponent as i32 - 150);
    }
}
