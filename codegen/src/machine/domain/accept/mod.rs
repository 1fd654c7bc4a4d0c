//! Acceptance intervals: what a conforming GPU may return.
//!
//! WGSL does not say what a shader computes to the last bit. Each operation has an accuracy (WGSL 15.7.4), so from
//! given inputs there is a set of results that an implementation may give. This domain computes an interval around
//! that set, in the manner of the WebGPU conformance test suite (`floating_point.ts`, `fp_primer.md`): a GPU result is
//! right if it lies inside. The rules:
//! - a correctly rounded result may be either neighbour of the exact one;
//! - a function whose error is "inherited" is evaluated by the formula it inherits from;
//! - subnormal numbers, in or out, may be zero;
//! - overflow, division by (nearly) zero and arguments outside a function's domain give the unbounded interval, which
//!   accepts anything, NaN included, as does everything computed from it;
//! - an expression may be fused (`a * b + c` rounded once): the exact product lies in the product's interval;
//! - `dot` may be summed in any order.
//!
//! Compilers may reassociate sums in the shader's own text as well (WGSL 15.7.5); that is not modelled. A node
//! whose text invites it says what it means instead: `mix(1.0, b, t)`, not `1.0 + t * (b - 1.0)`, which compilers turn
//! into the former.
//!
//! Integers are sets of a few values, or ranges. A condition on overlapping intervals is open: both sides run.

mod arithmetic;
mod convert;
mod inherited;
mod integers;
mod interval;
mod region;
mod transcendental;

pub use integers::Integers;
pub use interval::Interval;

use super::{
    Domain, FloatBinary, FloatComparison, FloatTernary, FloatUnary, IntBinary, IntComparison, IntUnary, TruthBinary,
};
use crate::machine::texture::{Load, Sample, Textures};

/// Intervals that hold whatever a conforming implementation may compute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Accept;

/// A condition that may be open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Three {
    /// It does not hold.
    #[default]
    False,
    /// It holds.
    True,
    /// Implementations may differ.
    Open,
}

impl From<bool> for Three {
    fn from(value: bool) -> Self {
        if value { Self::True } else { Self::False }
    }
}

impl Three {
    /// From the truth of the condition and of its opposite, if either is certain.
    fn of(certain: bool, impossible: bool) -> Self {
        match (certain, impossible) {
            (true, _) => Self::True,
            (false, true) => Self::False,
            (false, false) => Self::Open,
        }
    }
}

impl Domain for Accept {
    type Float = Interval;
    type Int = Integers;
    type Truth = Three;

    const DECIDED: bool = false;

    fn float(value: f32) -> Interval {
        Interval::point(value)
    }

    fn int(bits: u32) -> Integers {
        Integers::one(bits)
    }

    fn truth(value: bool) -> Three {
        value.into()
    }

    fn float_unary(op: FloatUnary, x: Interval) -> Interval {
        if x.is_unbounded() { x } else { arithmetic::unary(op, x) }
    }

    fn float_binary(op: FloatBinary, a: Interval, b: Interval) -> Interval {
        if a.is_unbounded() || b.is_unbounded() { Interval::UNBOUNDED } else { arithmetic::binary(op, a, b) }
    }

    fn float_ternary(op: FloatTernary, a: Interval, b: Interval, c: Interval) -> Interval {
        if [a, b, c].iter().any(Interval::is_unbounded) {
            return Interval::UNBOUNDED;
        }
        inherited::ternary(op, a, b, c)
    }

    fn dot(a: &[Interval], b: &[Interval]) -> Interval {
        inherited::dot(a, b)
    }

    fn square_sum(x: &[Interval]) -> Interval {
        inherited::square_sum(x)
    }

    fn float_comparison(op: FloatComparison, a: Interval, b: Interval) -> Three {
        arithmetic::compare(op, a, b)
    }

    fn int_unary(op: IntUnary, x: Integers) -> Integers {
        x.map(|x| op.apply(x))
    }

    fn int_binary(op: IntBinary, a: Integers, b: Integers) -> Integers {
        a.combine(op, b)
    }

    fn int_comparison(op: IntComparison, a: Integers, b: Integers) -> Three {
        a.compare(op, b)
    }

    fn not(x: Three) -> Three {
        match x {
            Three::False => Three::True,
            Three::True => Three::False,
            Three::Open => Three::Open,
        }
    }

    fn truth_binary(op: TruthBinary, a: Three, b: Three) -> Three {
        match (op, a, b) {
            (TruthBinary::And, Three::False, _) | (TruthBinary::And, _, Three::False) => Three::False,
            (TruthBinary::Or, Three::True, _) | (TruthBinary::Or, _, Three::True) => Three::True,
            (_, Three::Open, _) | (_, _, Three::Open) => Three::Open,
            (TruthBinary::And, ..) => Three::True,
            (TruthBinary::Or, ..) => Three::False,
            (TruthBinary::Equal, a, b) => (a == b).into(),
            (TruthBinary::NotEqual, a, b) => (a != b).into(),
        }
    }

    fn float_from_int(signed: bool, x: Integers) -> Interval {
        convert::float_from_int(signed, x)
    }

    fn int_from_float(signed: bool, x: Interval) -> Integers {
        convert::int_from_float(signed, x)
    }

    fn float_from_bits(x: Integers) -> Interval {
        convert::float_from_bits(x)
    }

    fn bits_from_float(x: Interval) -> Integers {
        convert::bits_from_float(x)
    }

    fn half_bits(x: Interval) -> Integers {
        convert::half_bits(x)
    }

    fn float_from_half(x: Integers) -> Interval {
        convert::float_from_half(x)
    }

    fn exponent(x: Interval) -> Integers {
        convert::exponent(x)
    }

    fn scale(x: Interval, exponent: Integers) -> Interval {
        convert::scale(x, exponent)
    }

    fn select_float(condition: Three, accept: Interval, reject: Interval) -> Interval {
        match condition {
            Three::True => accept,
            Three::False => reject,
            Three::Open => accept.join(reject),
        }
    }

    fn select_int(condition: Three, accept: Integers, reject: Integers) -> Integers {
        match condition {
            Three::True => accept,
            Three::False => reject,
            Three::Open => accept.join(reject),
        }
    }

    fn select_truth(condition: Three, accept: Three, reject: Three) -> Three {
        match condition {
            Three::True => accept,
            Three::False => reject,
            Three::Open if accept == reject => accept,
            Three::Open => Three::Open,
        }
    }

    fn decide(condition: Three) -> Option<bool> {
        match condition {
            Three::True => Some(true),
            Three::False => Some(false),
            Three::Open => None,
        }
    }

    fn known(x: Integers) -> Option<u32> {
        match x.values() {
            Some([value]) => Some(*value),
            _ => None,
        }
    }

    fn candidates(x: Integers) -> Option<Vec<u32>> {
        x.values().map(<[u32]>::to_vec)
    }

    fn undecided() -> Three {
        Three::Open
    }

    fn any_float() -> Interval {
        Interval::UNBOUNDED
    }

    fn any_int() -> Integers {
        Integers::ANY
    }

    fn sample(textures: &dyn Textures, sample: &Sample<Interval, Integers>) -> Option<[Interval; 4]> {
        region::sample(textures, sample)
    }

    fn load(textures: &dyn Textures, load: &Load<Integers>) -> Option<[Interval; 4]> {
        region::load(textures, load)
    }

    fn load_int(textures: &dyn Textures, load: &Load<Integers>) -> Option<[Integers; 4]> {
        region::load_int(textures, load)
    }
}
