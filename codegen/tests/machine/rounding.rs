//! `F32` against exactly rounded results, over floats of every magnitude.

use terrane_codegen::machine::domain::{Domain, F32, F64, FloatBinary, FloatUnary};

use crate::support::floats;

/// An operation and what it computes.
type Exact = (FloatUnary, fn(f64) -> f64);

/// What each operation must give to the last bit: the exact result, which `f64` holds or rounds harmlessly, rounded.
const EXACT: [Exact; 10] = [
    (FloatUnary::Negate, |x| -x),
    (FloatUnary::Abs, f64::abs),
    (FloatUnary::Floor, f64::floor),
    (FloatUnary::Ceil, f64::ceil),
    (FloatUnary::Round, f64::round_ties_even),
    (FloatUnary::Trunc, f64::trunc),
    (FloatUnary::Fract, |x| x - x.floor()),
    (FloatUnary::Sqrt, f64::sqrt),
    (FloatUnary::InverseSqrt, |x| 1.0 / x.sqrt()),
    (FloatUnary::Sign, |x| if x == 0.0 || x.is_nan() { 0.0 } else { x.signum() }),
];

fn check(values: impl Iterator<Item = f32>) {
    for x in values {
        for (op, exact) in EXACT {
            let (found, expected) = (F32::float_unary(op, x), exact(f64::from(x)) as f32);
            let same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
            assert!(same, "{op:?} of {x:e} is {found:e}, not {expected:e}");
        }
    }
}

#[test]
fn exact_operations_are_exact() {
    check(floats(1021));
}

#[test]
#[ignore = "takes minutes: all 2^32 floats"]
fn exact_operations_are_exact_everywhere() {
    check(floats(1));
}

#[test]
fn binary_operations_are_those_of_ieee() {
    let values: Vec<f32> = floats(4_000_037).collect();
    for (a, b) in values.iter().flat_map(|a| values.iter().map(move |b| (*a, *b))) {
        let of = |op| F32::float_binary(op, a, b).to_bits();
        let both = (f64::from(a), f64::from(b));
        let bits = |value: f64| (value as f32).to_bits();
        // Twice rounding is as good as once: f64 has more than twice the digits, and two to spare.
        if a.is_finite() && b.is_finite() {
            assert_eq!(of(FloatBinary::Add), bits(both.0 + both.1), "{a} + {b}");
            assert_eq!(of(FloatBinary::Subtract), bits(both.0 - both.1), "{a} - {b}");
            assert_eq!(of(FloatBinary::Multiply), bits(both.0 * both.1), "{a} * {b}");
            if b != 0.0 {
                assert_eq!(of(FloatBinary::Divide), bits(both.0 / both.1), "{a} / {b}");
            }
            assert_eq!(F32::float_binary(FloatBinary::Min, a, b), a.min(b), "min({a}, {b})");
            assert_eq!(F32::float_binary(FloatBinary::Max, a, b), a.max(b), "max({a}, {b})");
        }
    }
}

#[test]
fn transcendental_functions_are_within_half_a_unit_of_std() {
    let functions: [Exact; 16] = [
        (FloatUnary::Exp, f64::exp),
        (FloatUnary::Exp2, f64::exp2),
        (FloatUnary::Log, f64::ln),
        (FloatUnary::Log2, f64::log2),
        (FloatUnary::Sin, f64::sin),
        (FloatUnary::Cos, f64::cos),
        (FloatUnary::Tan, f64::tan),
        (FloatUnary::Sinh, f64::sinh),
        (FloatUnary::Cosh, f64::cosh),
        (FloatUnary::Tanh, f64::tanh),
        (FloatUnary::Asin, f64::asin),
        (FloatUnary::Acos, f64::acos),
        (FloatUnary::Atan, f64::atan),
        (FloatUnary::Asinh, f64::asinh),
        (FloatUnary::Acosh, f64::acosh),
        (FloatUnary::Atanh, f64::atanh),
    ];
    for x in floats(65_537).filter(|x| x.abs() < 1e6) {
        for (op, reference) in functions {
            let (single, double) = (F32::float_unary(op, x), F64::float_unary(op, f64::from(x)));
            let expected = reference(f64::from(x));
            if expected.is_nan() {
                assert!(single.is_nan() && double.is_nan(), "{op:?} of {x}");
                continue;
            }
            // Std's own inverse hyperbolic functions lose digits near zero, so the bound on f64 is not tight.
            let close = (double - expected).abs() <= 1e-10 * expected.abs() + 1e-15 || double == expected;
            assert!(close, "{op:?} of {x}: {double:e}, std says {expected:e}");
            assert_eq!(single.to_bits(), (double as f32).to_bits(), "{op:?} of {x}");
        }
    }
}
