//! Operations with an accuracy of their own in WGSL's table (15.7.4.1).

use super::super::{FloatBinary, FloatComparison, FloatUnary, half};
use super::interval::{Interval, down, relative, ulp, up};
use super::{Three, inherited, transcendental};

/// One bounded operand.
pub(super) fn unary(op: FloatUnary, x: Interval) -> Interval {
    let exact = |f: fn(f32) -> f32| Interval::new(f(x.low()), f(x.high()));
    match op {
        FloatUnary::Negate => Interval::new(-x.high(), -x.low()),
        FloatUnary::Abs if x.has_zero() => Interval::new(0.0, x.high().max(-x.low())),
        FloatUnary::Abs => Interval::new(x.low().abs().min(x.high().abs()), x.low().abs().max(x.high().abs())),
        FloatUnary::Sign => exact(|x| if x == 0.0 { 0.0 } else { x.signum() }),
        FloatUnary::Floor => exact(f32::floor),
        FloatUnary::Ceil => exact(f32::ceil),
        FloatUnary::Round => exact(f32::round_ties_even),
        FloatUnary::Trunc => exact(f32::trunc),
        FloatUnary::Fract => fract(x),
        FloatUnary::Saturate => exact(|x| x.clamp(0.0, 1.0)),
        FloatUnary::Square => square(x),
        FloatUnary::InverseSqrt => inverse_sqrt(x),
        FloatUnary::QuantizeToF16 => quantize(x),
        FloatUnary::FrexpFraction => frexp_fraction(x),
        FloatUnary::Unspecified => Interval::UNBOUNDED,
        FloatUnary::Exp
        | FloatUnary::Exp2
        | FloatUnary::Log
        | FloatUnary::Log2
        | FloatUnary::Sin
        | FloatUnary::Cos
        | FloatUnary::Atan => transcendental::unary(op, x),
        _ => inherited::unary(op, x),
    }
}

/// Two bounded operands.
pub(super) fn binary(op: FloatBinary, a: Interval, b: Interval) -> Interval {
    match op {
        FloatBinary::Add => add(a, b),
        FloatBinary::Subtract => add(a, Interval::new(-b.high(), -b.low())),
        FloatBinary::Multiply => multiply(a, b),
        FloatBinary::Divide => divide(a, b),
        FloatBinary::Min => Interval::new(a.low().min(b.low()), a.high().min(b.high())),
        FloatBinary::Max => Interval::new(a.low().max(b.low()), a.high().max(b.high())),
        FloatBinary::Step => match compare(FloatComparison::LessEqual, a, b) {
            Three::False => Interval::point(0.0),
            Three::True => Interval::point(1.0),
            Three::Open => Interval::new(0.0, 1.0),
        },
        FloatBinary::Atan2 => transcendental::atan2(a, b),
        FloatBinary::Remainder | FloatBinary::Pow => inherited::binary(op, a, b),
    }
}

pub(super) fn add(a: Interval, b: Interval) -> Interval {
    let ((a_low, a_high), (b_low, b_high)) = (a.bounds(), b.bounds());
    Interval::new(down_sum(a_low, b_low), -down_sum(-a_high, -b_high))
}

/// The largest `f32` that is not above the exact sum; `f64` may have rounded the sum up to an `f32`.
fn down_sum(a: f64, b: f64) -> f32 {
    let sum = a + b;
    let (a_part, b_part) = (sum - b, sum - (sum - b));
    let lost = (a - a_part) + (b - b_part);
    let rounded = down(sum);
    if f64::from(rounded) == sum && lost < 0.0 { rounded.next_down() } else { rounded }
}

pub(super) fn multiply(a: Interval, b: Interval) -> Interval {
    // The product of two `f32` is exact in `f64`.
    let (low, high) = corners(a, b, |a, b| a * b);
    Interval::rounded(low, high)
}

/// The product of a number with itself, which is never negative.
fn square(x: Interval) -> Interval {
    let (low, high) = unary(FloatUnary::Abs, x).bounds();
    Interval::rounded(low * low, high * high)
}

/// 2.5 ULP for a divisor of magnitude 2^-126 to 2^126, else nothing is known.
pub(super) fn divide(a: Interval, b: Interval) -> Interval {
    let magnitude = unary(FloatUnary::Abs, b);
    if !magnitude.within(f64::from(f32::MIN_POSITIVE), 2_f64.powi(126)) {
        return Interval::UNBOUNDED;
    }
    let (low, high) = corners(a, b, |a, b| a / b);
    widened(low, high, 2.5)
}

/// The interval between the bounds of a result, each with an error in units in the last place.
pub(super) fn widened(low: f64, high: f64, units: f64) -> Interval {
    // What `f64` itself may be wrong by.
    let units = units + 1e-6;
    if low == high {
        let error = units * ulp(low);
        return Interval::outside(low, high, error, error);
    }
    Interval::outside(low, high, relative(units, low), relative(units, high))
}

/// The bounds of an operation that is monotone in each operand, over a rectangle.
pub(super) fn corners(a: Interval, b: Interval, f: impl Fn(f64, f64) -> f64) -> (f64, f64) {
    let ((a_low, a_high), (b_low, b_high)) = (a.bounds(), b.bounds());
    let values = [f(a_low, b_low), f(a_low, b_high), f(a_high, b_low), f(a_high, b_high)];
    values.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
}

/// `x - floor(x)`, which is in 0..1 wherever x is; 1 for a small negative x.
fn fract(x: Interval) -> Interval {
    let (low, high) = x.bounds();
    if low.floor() == high.floor() {
        return Interval::rounded(low - low.floor(), high - high.floor());
    }
    Interval::new(0.0, 1.0)
}

/// 2 ULP for positive x.
pub(super) fn inverse_sqrt(x: Interval) -> Interval {
    let (low, high) = x.bounds();
    if low <= 0.0 {
        return Interval::UNBOUNDED;
    }
    widened(1.0 / high.sqrt(), 1.0 / low.sqrt(), 2.0)
}

fn quantize(x: Interval) -> Interval {
    let (low, high) = x.bounds();
    let (low, high) = (half::down(low), half::up(high));
    // Subnormal half floats may be flushed as well.
    let low = if low > 0.0 && low < half::SMALLEST_NORMAL { 0.0 } else { low };
    let high = if high < 0.0 && high > -half::SMALLEST_NORMAL { 0.0 } else { high };
    Interval::rounded(low, high)
}

fn frexp_fraction(x: Interval) -> Interval {
    let ((low, low_exponent), (high, high_exponent)) = (libm::frexpf(x.low()), libm::frexpf(x.high()));
    if low_exponent == high_exponent && (low > 0.0 || high < 0.0 || x.is_point()) {
        return Interval::new(low, high);
    }
    Interval::new(if x.low() < 0.0 { -1.0 } else { 0.0 }, if x.high() > 0.0 { 1.0 } else { 0.0 })
}

/// Comparisons are exact, of what is compared.
pub(super) fn compare(op: FloatComparison, a: Interval, b: Interval) -> Three {
    if a.is_unbounded() || b.is_unbounded() {
        return Three::Open;
    }
    let disjoint = a.high() < b.low() || b.high() < a.low();
    let equal = a.is_point() && a == b;
    match op {
        FloatComparison::Equal => Three::of(equal, disjoint),
        FloatComparison::NotEqual => Three::of(disjoint, equal),
        FloatComparison::Less => Three::of(a.high() < b.low(), a.low() >= b.high()),
        FloatComparison::LessEqual => Three::of(a.high() <= b.low(), a.low() > b.high()),
    }
}

/// A constant that is not an `f32`: implementations may round it either way.
pub(super) fn constant(value: f64) -> Interval {
    Interval::new(down(value), up(value))
}
