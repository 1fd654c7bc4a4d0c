//! `f64` where the shader says `f32`: the reference that errors are measured against.

use super::concrete::{I32_RANGE, Real, U32_RANGE, concrete};
use super::{
    Domain, FloatBinary, FloatComparison, FloatTernary, FloatUnary, IntBinary, IntComparison, IntUnary, TruthBinary,
    half,
};
use crate::machine::texture::{Load, Sample, Textures};

/// Every `f32` held in `f64`. Constants are the shader's, so a rounded pi stays rounded. Bit patterns are those of the
/// nearest `f32`, and `quantizeToF16` rounds as ever, for their meaning is the rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct F64;

impl Domain for F64 {
    type Float = f64;
    type Int = u32;
    type Truth = bool;

    concrete!();

    #[inline(always)]
    fn float(value: f32) -> f64 {
        f64::from(value)
    }

    #[inline(always)]
    fn float_unary(op: FloatUnary, x: f64) -> f64 {
        match op {
            FloatUnary::Negate => -x,
            FloatUnary::Abs => x.abs(),
            FloatUnary::Sign => {
                if x > 0.0 {
                    1.0
                } else if x < 0.0 {
                    -1.0
                } else {
                    0.0
                }
            }
            FloatUnary::Floor => x.floor(),
            FloatUnary::Ceil => x.ceil(),
            FloatUnary::Round => x.round_ties_even(),
            FloatUnary::Trunc => x.trunc(),
            FloatUnary::Fract => x - x.floor(),
            FloatUnary::Saturate => Self::float_ternary(FloatTernary::Clamp, x, 0.0, 1.0),
            FloatUnary::Square => x * x,
            FloatUnary::Sqrt => x.sqrt(),
            FloatUnary::InverseSqrt => 1.0 / x.sqrt(),
            FloatUnary::Radians => x.to_radians(),
            FloatUnary::Degrees => x.to_degrees(),
            FloatUnary::Unspecified => x,
            FloatUnary::QuantizeToF16 => half::from_bits(half::to_bits(x)),
            FloatUnary::FrexpFraction => libm::frexp(x).0,
            _ => transcendental(op, x),
        }
    }

    #[inline(always)]
    fn float_binary(op: FloatBinary, a: f64, b: f64) -> f64 {
        match op {
            FloatBinary::Add => a + b,
            FloatBinary::Subtract => a - b,
            FloatBinary::Multiply => a * b,
            FloatBinary::Divide => a / b,
            FloatBinary::Remainder => a % b,
            FloatBinary::Min => {
                if b < a {
                    b
                } else {
                    a
                }
            }
            FloatBinary::Max => {
                if a < b {
                    b
                } else {
                    a
                }
            }
            FloatBinary::Step => {
                if a <= b {
                    1.0
                } else {
                    0.0
                }
            }
            FloatBinary::Pow => pow(a, b),
            FloatBinary::Atan2 => libm::atan2(a, b),
        }
    }

    #[inline(always)]
    fn float_ternary(op: FloatTernary, a: f64, b: f64, c: f64) -> f64 {
        match op {
            FloatTernary::Clamp => {
                let raised = if a < b { b } else { a };
                if c < raised { c } else { raised }
            }
            FloatTernary::Fma => a * b + c,
            FloatTernary::Mix => a * (1.0 - c) + b * c,
            FloatTernary::SmoothStep => {
                let t = Self::float_ternary(FloatTernary::Clamp, (c - a) / (b - a), 0.0, 1.0);
                t * t * (3.0 - 2.0 * t)
            }
        }
    }

    #[inline(always)]
    fn float_from_int(signed: bool, x: u32) -> f64 {
        if signed { f64::from(x as i32) } else { f64::from(x) }
    }

    #[inline(always)]
    fn int_from_float(signed: bool, x: f64) -> u32 {
        if signed {
            x.clamp(f64::from(I32_RANGE.0), f64::from(I32_RANGE.1)) as i32 as u32
        } else {
            x.clamp(f64::from(U32_RANGE.0), f64::from(U32_RANGE.1)) as u32
        }
    }

    #[inline(always)]
    fn float_from_bits(x: u32) -> f64 {
        f64::from(f32::from_bits(x))
    }

    #[inline(always)]
    fn bits_from_float(x: f64) -> u32 {
        (x as f32).to_bits()
    }

    fn half_bits(x: f64) -> u32 {
        half::to_bits(x)
    }

    fn float_from_half(x: u32) -> f64 {
        half::from_bits(x)
    }

    fn exponent(x: f64) -> u32 {
        libm::frexp(x).1 as u32
    }

    fn scale(x: f64, exponent: u32) -> f64 {
        libm::ldexp(x, exponent as i32)
    }
}

impl Real for F64 {
    fn wide(x: f64) -> f64 {
        x
    }

    fn measured(value: f64) -> f64 {
        value
    }
}

/// The functions for which there is no exact answer.
///
/// # Panics
/// If the operation is not one of them.
pub(super) fn transcendental(op: FloatUnary, x: f64) -> f64 {
    match op {
        FloatUnary::Exp => libm::exp(x),
        FloatUnary::Exp2 => libm::exp2(x),
        FloatUnary::Log => libm::log(x),
        FloatUnary::Log2 => libm::log2(x),
        FloatUnary::Sin => libm::sin(x),
        FloatUnary::Cos => libm::cos(x),
        FloatUnary::Tan => libm::tan(x),
        FloatUnary::Sinh => libm::sinh(x),
        FloatUnary::Cosh => libm::cosh(x),
        FloatUnary::Tanh => libm::tanh(x),
        FloatUnary::Asin => libm::asin(x),
        FloatUnary::Acos => libm::acos(x),
        FloatUnary::Atan => libm::atan(x),
        FloatUnary::Asinh => libm::asinh(x),
        // `libm` answers outside the domain too.
        FloatUnary::Acosh if x < 1.0 => f64::NAN,
        FloatUnary::Acosh => libm::acosh(x),
        FloatUnary::Atanh => libm::atanh(x),
        other => unreachable!("{other:?} is computed by its domain"),
    }
}

/// `pow` on WGSL's domain: a negative base has no value (WGSL 17.5.46), which NaN shows.
pub(super) fn pow(base: f64, exponent: f64) -> f64 {
    if base < 0.0 { f64::NAN } else { libm::pow(base, exponent) }
}
