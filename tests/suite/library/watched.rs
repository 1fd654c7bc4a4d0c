//! The shader's arithmetic, watched: remembers the first operation that WGSL leaves undefined, even if nobody used its result.
//!
//! A result outside the representable numbers is "indeterminate" in WGSL, and so may be what a `select` makes of it: looking at
//! results alone would miss `select(a / b, 0.0, b == 0.0)`.

use std::cell::RefCell;

use terrane_codegen::machine::domain::{
    FloatBinary, FloatComparison, FloatTernary, FloatUnary, IntBinary, IntComparison, IntUnary, TruthBinary,
};
use terrane_codegen::machine::{Domain, F32, Load, Sample, Textures};

thread_local! {
    static FIRST: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// What has gone wrong since the last call, if anything.
pub(super) fn take_hazard() -> Option<String> {
    FIRST.take()
}

fn watch(safe: bool, operation: impl FnOnce() -> String) {
    FIRST.with_borrow_mut(|first| {
        if !safe && first.is_none() {
            *first = Some(operation());
        }
    });
}

fn unary_is_defined(op: FloatUnary, x: f32) -> bool {
    match op {
        FloatUnary::Sqrt => x >= 0.0,
        FloatUnary::InverseSqrt | FloatUnary::Log | FloatUnary::Log2 => x >= f32::MIN_POSITIVE,
        FloatUnary::Asin | FloatUnary::Acos => x.abs() <= 1.0,
        // WGSL states no accuracy beyond.
        FloatUnary::Sin | FloatUnary::Cos | FloatUnary::Tan => x.abs() <= std::f32::consts::PI,
        _ => true,
    }
}

fn binary_is_defined(op: FloatBinary, a: f32, b: f32) -> bool {
    match op {
        // WGSL states the accuracy of divisors from 2^-126 to 2^126.
        FloatBinary::Divide | FloatBinary::Remainder => (f32::MIN_POSITIVE..=8.507_059e37).contains(&b.abs()),
        FloatBinary::Pow => a >= f32::MIN_POSITIVE,
        FloatBinary::Atan2 => b.abs() >= f32::MIN_POSITIVE,
        _ => true,
    }
}

fn ternary_is_defined(op: FloatTernary, a: f32, b: f32, c: f32) -> bool {
    match op {
        FloatTernary::Clamp => b <= c,
        FloatTernary::SmoothStep => a < b,
        FloatTernary::Fma | FloatTernary::Mix => true,
    }
}

/// `F32`, watched.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watched;

impl Domain for Watched {
    type Float = f32;
    type Int = u32;
    type Truth = bool;

    const DECIDED: bool = true;

    fn float_unary(op: FloatUnary, x: f32) -> f32 {
        let result = F32::float_unary(op, x);
        watch(unary_is_defined(op, x) && result.is_finite(), || format!("{op:?}({x:?})"));
        result
    }
    fn float_binary(op: FloatBinary, a: f32, b: f32) -> f32 {
        let result = F32::float_binary(op, a, b);
        watch(binary_is_defined(op, a, b) && result.is_finite(), || format!("{op:?}({a:?}, {b:?})"));
        result
    }
    fn float_ternary(op: FloatTernary, a: f32, b: f32, c: f32) -> f32 {
        let result = F32::float_ternary(op, a, b, c);
        watch(ternary_is_defined(op, a, b, c) && result.is_finite(), || format!("{op:?}({a:?}, {b:?}, {c:?})"));
        result
    }
    fn dot(a: &[f32], b: &[f32]) -> f32 {
        let result = F32::dot(a, b);
        watch(result.is_finite(), || format!("Dot({a:?}, {b:?})"));
        result
    }

    fn float(value: f32) -> f32 {
        F32::float(value)
    }
    fn int(bits: u32) -> u32 {
        F32::int(bits)
    }
    fn truth(value: bool) -> bool {
        F32::truth(value)
    }
    fn float_comparison(op: FloatComparison, a: f32, b: f32) -> bool {
        F32::float_comparison(op, a, b)
    }
    fn int_unary(op: IntUnary, x: u32) -> u32 {
        F32::int_unary(op, x)
    }
    fn int_binary(op: IntBinary, a: u32, b: u32) -> u32 {
        F32::int_binary(op, a, b)
    }
    fn int_comparison(op: IntComparison, a: u32, b: u32) -> bool {
        F32::int_comparison(op, a, b)
    }
    fn not(x: bool) -> bool {
        F32::not(x)
    }
    fn truth_binary(op: TruthBinary, a: bool, b: bool) -> bool {
        F32::truth_binary(op, a, b)
    }
    fn float_from_int(signed: bool, x: u32) -> f32 {
        F32::float_from_int(signed, x)
    }
    fn int_from_float(signed: bool, x: f32) -> u32 {
        F32::int_from_float(signed, x)
    }
    fn float_from_bits(x: u32) -> f32 {
        F32::float_from_bits(x)
    }
    fn bits_from_float(x: f32) -> u32 {
        F32::bits_from_float(x)
    }
    fn half_bits(x: f32) -> u32 {
        F32::half_bits(x)
    }
    fn float_from_half(x: u32) -> f32 {
        F32::float_from_half(x)
    }
    fn exponent(x: f32) -> u32 {
        F32::exponent(x)
    }
    fn scale(x: f32, exponent: u32) -> f32 {
        F32::scale(x, exponent)
    }
    fn select_float(condition: bool, accept: f32, reject: f32) -> f32 {
        F32::select_float(condition, accept, reject)
    }
    fn select_int(condition: bool, accept: u32, reject: u32) -> u32 {
        F32::select_int(condition, accept, reject)
    }
    fn select_truth(condition: bool, accept: bool, reject: bool) -> bool {
        F32::select_truth(condition, accept, reject)
    }
    fn decide(condition: bool) -> Option<bool> {
        F32::decide(condition)
    }
    fn known(x: u32) -> Option<u32> {
        F32::known(x)
    }
    fn candidates(x: u32) -> Option<Vec<u32>> {
        F32::candidates(x)
    }
    fn sample(textures: &dyn Textures, sample: &Sample<f32, u32>) -> Option<[f32; 4]> {
        F32::sample(textures, sample)
    }
    fn load(textures: &dyn Textures, load: &Load<u32>) -> Option<[f32; 4]> {
        F32::load(textures, load)
    }
    fn load_int(textures: &dyn Textures, load: &Load<u32>) -> Option<[u32; 4]> {
        F32::load_int(textures, load)
    }
}
