//! `f32`, as a shader computes it.

use super::concrete::{I32_RANGE, Real, U32_RANGE, concrete};
use super::{
    Domain, FloatBinary, FloatComparison, FloatTernary, FloatUnary, IntBinary, IntComparison, IntUnary, TruthBinary,
    half,
};
use crate::machine::texture::{Load, Sample, Textures};

/// Every operation rounded to `f32`, to nearest; composite builtins by the formula in WGSL's accuracy table.
///
/// Transcendental functions are computed in `f64` by `libm` and rounded once: the same bits on every platform, and
/// within half a unit in the last place but for about one argument in 10^8. `fma` rounds twice, as WGSL allows.
/// Subnormal numbers are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct F32;

impl Domain for F32 {
    type Float = f32;
    type Int = u32;
    type Truth = bool;

    concrete!();

    #[inline(always)]
    fn float(value: f32) -> f32 {
        value
    }

    #[inline(always)]
    fn float_unary(op: FloatUnary, x: f32) -> f32 {
        match op {
            FloatUnary::Negate => -x,
            FloatUnary::Abs => x.abs(),
            FloatUnary::Sign => sign(x),
            FloatUnary::Floor => floor(x),
            FloatUnary::Ceil => -floor(-x),
            FloatUnary::Round => round(x),
            FloatUnary::Trunc => trunc(x),
            FloatUnary::Fract => x - floor(x),
            FloatUnary::Saturate => Self::float_ternary(FloatTernary::Clamp, x, 0.0, 1.0),
            FloatUnary::Square => x * x,
            FloatUnary::Sqrt => x.sqrt(),
            FloatUnary::InverseSqrt => (1.0 / f64::from(x).sqrt()) as f32,
            FloatUnary::Radians => x * (std::f32::consts::PI / 180.0),
            FloatUnary::Degrees => x * (180.0 / std::f32::consts::PI),
            FloatUnary::Unspecified => x,
            FloatUnary::QuantizeToF16 => half::from_bits(half::to_bits(f64::from(x))) as f32,
            FloatUnary::FrexpFraction => libm::frexpf(x).0,
            _ => super::double::transcendental(op, f64::from(x)) as f32,
        }
    }

    #[inline(always)]
    fn float_binary(op: FloatBinary, a: f32, b: f32) -> f32 {
        match op {
            FloatBinary::Add => a + b,
            FloatBinary::Subtract => a - b,
            FloatBinary::Multiply => a * b,
            FloatBinary::Divide => a / b,
            FloatBinary::Remainder => a - b * trunc(a / b),
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
            FloatBinary::Pow => super::double::pow(f64::from(a), f64::from(b)) as f32,
            FloatBinary::Atan2 => libm::atan2(f64::from(a), f64::from(b)) as f32,
        }
    }

    #[inline(always)]
    fn float_ternary(op: FloatTernary, a: f32, b: f32, c: f32) -> f32 {
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
    fn float_from_int(signed: bool, x: u32) -> f32 {
        if signed { x as i32 as f32 } else { x as f32 }
    }

    #[inline(always)]
    fn int_from_float(signed: bool, x: f32) -> u32 {
        if signed { x.clamp(I32_RANGE.0, I32_RANGE.1) as i32 as u32 } else { x.clamp(U32_RANGE.0, U32_RANGE.1) as u32 }
    }

    #[inline(always)]
    fn float_from_bits(x: u32) -> f32 {
        f32::from_bits(x)
    }

    #[inline(always)]
    fn bits_from_float(x: f32) -> u32 {
        x.to_bits()
    }

    fn half_bits(x: f32) -> u32 {
        half::to_bits(f64::from(x))
    }

    fn float_from_half(x: u32) -> f32 {
        half::from_bits(x) as f32
    }

    fn exponent(x: f32) -> u32 {
        libm::frexpf(x).1 as u32
    }

    fn scale(x: f32, exponent: u32) -> f32 {
        libm::ldexpf(x, exponent as i32)
    }
}

impl Real for F32 {
    fn wide(x: f32) -> f64 {
        f64::from(x)
    }

    fn measured(value: f64) -> f32 {
        value as f32
    }
}

/// 2^23: floats of this magnitude are whole, and adding it rounds smaller ones to whole numbers.
const WHOLE: f32 = 8_388_608.0;

/// To the nearest whole number, ties to even. Written with additions because the baseline x86-64 has no instruction
/// for it, and these are vectorised.
#[inline(always)]
fn round(x: f32) -> f32 {
    let magnitude = x.abs();
    let whole = ((magnitude + WHOLE) - WHOLE).copysign(x);
    if magnitude < WHOLE { whole } else { x }
}

#[inline(always)]
fn floor(x: f32) -> f32 {
    let near = round(x);
    (if near > x { near - 1.0 } else { near }).copysign(x)
}

#[inline(always)]
fn trunc(x: f32) -> f32 {
    floor(x.abs()).copysign(x)
}

#[inline(always)]
fn sign(x: f32) -> f32 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        0.0
    }
}
