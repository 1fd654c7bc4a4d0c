//! Between floats, integers and bits.

use super::super::concrete::{I32_RANGE, U32_RANGE};
use super::super::half;
use super::Integers;
use super::interval::{Interval, down, up};

/// Correctly rounded.
pub(super) fn float_from_int(signed: bool, x: Integers) -> Interval {
    let (low, high) = if signed {
        let (low, high) = x.signed_bounds();
        (f64::from(low), f64::from(high))
    } else {
        let (low, high) = x.bounds();
        (f64::from(low), f64::from(high))
    };
    Interval::rounded(low, high)
}

/// Clamped, then truncated.
pub(super) fn int_from_float(signed: bool, x: Interval) -> Integers {
    if x.is_unbounded() {
        return Integers::ANY;
    }
    let (low, high) = x.bounds();
    if signed {
        let whole = |x: f64| x.clamp(f64::from(i32::MIN), f64::from(i32::MAX)) as i64;
        let (mut low, high) = (whole(low), whole(high));
        // Implementations clamp to the largest float below the range's end, or to the end.
        if high > I32_RANGE.1 as i64 {
            low = low.min(I32_RANGE.1 as i64);
        }
        return signed_range(low, high);
    }
    let whole = |x: f64| x.clamp(0.0, f64::from(u32::MAX)) as u32;
    let (mut low, high) = (whole(low), whole(high));
    if high > U32_RANGE.1 as u32 {
        low = low.min(U32_RANGE.1 as u32);
    }
    Integers::range(low, high)
}

fn signed_range(low: i64, high: i64) -> Integers {
    if high - low < 8 {
        return Integers::of((low..=high).map(|value| value as i32 as u32));
    }
    if low >= 0 || high < 0 { Integers::range(low as i32 as u32, high as i32 as u32) } else { Integers::ANY }
}

pub(super) fn float_from_bits(x: Integers) -> Interval {
    match x.values() {
        Some(values) => joined(values.iter().map(|bits| Interval::point(f32::from_bits(*bits)))),
        None => Interval::UNBOUNDED,
    }
}

/// Those of all floats in the interval, if they are few. The sign of a zero may be lost.
pub(super) fn bits_from_float(x: Interval) -> Integers {
    if x.is_unbounded() {
        return Integers::ANY;
    }
    if x.low() == 0.0 && x.high() == 0.0 {
        return Integers::of([0, 1 << 31]);
    }
    if x.low() > 0.0 {
        return Integers::range(x.low().to_bits(), x.high().to_bits());
    }
    if x.high() < 0.0 {
        return Integers::range(x.high().to_bits(), x.low().to_bits());
    }
    Integers::ANY
}

/// Either neighbour.
pub(super) fn half_bits(x: Interval) -> Integers {
    if !x.within(-half::LARGEST, half::LARGEST) {
        return Integers::ANY;
    }
    let (low, high) = x.bounds();
    let (low, high) = (half::to_bits(half::down(low)), half::to_bits(half::up(high)));
    let subnormal = |bits: u32| bits & 0x7c00 == 0;
    if low == high && !subnormal(low) {
        return Integers::one(low);
    }
    if subnormal(low) || subnormal(high) {
        return Integers::range(0, 0xffff);
    }
    // The bits of negative numbers ascend with the magnitude.
    if low >> 15 == high >> 15 { Integers::range(low.min(high), low.max(high)) } else { Integers::range(0, 0xffff) }
}

pub(super) fn float_from_half(x: Integers) -> Interval {
    let value = |bits: u32| {
        let value = half::from_bits(bits) as f32;
        let point = Interval::point(value);
        if f64::from(value.abs()) < half::SMALLEST_NORMAL { point.join(Interval::point(0.0)) } else { point }
    };
    match x.values() {
        Some(values) => joined(values.iter().map(|bits| value(*bits))),
        None => Interval::UNBOUNDED,
    }
}

/// The exponents from that of the number nearest to zero to that of the farthest.
pub(super) fn exponent(x: Interval) -> Integers {
    if x.is_unbounded() {
        return Integers::ANY;
    }
    let exponent = |x: f32| i64::from(libm::frexpf(x).1);
    if x.is_point() {
        return signed_range(exponent(x.low()), exponent(x.low()));
    }
    if x.has_zero() {
        return Integers::ANY;
    }
    let (a, b) = (exponent(x.low()), exponent(x.high()));
    signed_range(a.min(b), a.max(b))
}

/// `x * 2^exponent`, correctly rounded.
pub(super) fn scale(x: Interval, exponent: Integers) -> Interval {
    let (Some(values), false) = (exponent.values(), x.is_unbounded()) else { return Interval::UNBOUNDED };
    let (low, high) = x.bounds();
    joined(values.iter().map(|exponent| {
        let exponent = (*exponent as i32).clamp(-1000, 1000);
        Interval::new(down(libm::ldexp(low, exponent)), up(libm::ldexp(high, exponent)))
    }))
}

fn joined(intervals: impl Iterator<Item = Interval>) -> Interval {
    intervals.reduce(Interval::join).unwrap_or(Interval::UNBOUNDED)
}
