//! Functions with a stated error: exponentials, logarithms, trigonometry.

use std::f64::consts::{FRAC_PI_2, PI};

use super::super::FloatUnary;
use super::arithmetic::{corners, widened};
use super::interval::{Interval, relative, up};

/// One bounded operand.
///
/// # Panics
/// If the operation is not one of these.
pub(super) fn unary(op: FloatUnary, x: Interval) -> Interval {
    match op {
        FloatUnary::Exp => exponential(x, libm::exp),
        FloatUnary::Exp2 => exponential(x, libm::exp2),
        FloatUnary::Log => logarithm(x, libm::log),
        FloatUnary::Log2 => logarithm(x, libm::log2),
        FloatUnary::Sin => wave(x, libm::sin, &[-FRAC_PI_2, FRAC_PI_2]),
        FloatUnary::Cos => wave(x, libm::cos, &[-PI, 0.0, PI]),
        FloatUnary::Atan => {
            let (low, high) = x.bounds();
            widened(libm::atan(low), libm::atan(high), 4096.0)
        }
        other => unreachable!("{other:?} has no error of its own"),
    }
}

/// 3 + 2 |x| ULP.
fn exponential(x: Interval, f: fn(f64) -> f64) -> Interval {
    let (low, high) = x.bounds();
    if x.is_point() {
        return widened(f(low), f(low), 3.0 + 2.0 * low.abs());
    }
    let error = |x: f64| relative(3.0 + 2.0 * x.abs() + 1e-6, f(x));
    Interval::outside(f(low), f(high), error(low), error(high))
}

/// 2^-21 where x is in 0.5..2, else 3 ULP; for positive x.
fn logarithm(x: Interval, f: fn(f64) -> f64) -> Interval {
    let (low, high) = x.bounds();
    if low <= 0.0 {
        return Interval::UNBOUNDED;
    }
    let absolute = if low <= 2.0 && high >= 0.5 { 2_f64.powi(-21) } else { 0.0 };
    let units = |x: f64| if (0.5..=2.0).contains(&x) { 0.0 } else { relative(3.0 + 1e-6, f(x)) };
    Interval::outside(f(low), f(high), units(low).max(absolute), units(high).max(absolute))
}

/// 2^-11 for x in -pi..pi; `turns` are where the function has its extremes there.
fn wave(x: Interval, f: fn(f64) -> f64, turns: &[f64]) -> Interval {
    let pi = f64::from(up(PI));
    if !x.within(-pi, pi) {
        return Interval::UNBOUNDED;
    }
    let (low, high) = x.bounds();
    let inside = turns.iter().copied().filter(|turn| low < *turn && *turn < high);
    let values: Vec<f64> = inside.chain([low, high]).map(f).collect();
    let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let error = 2_f64.powi(-11);
    Interval::outside(lowest, highest, error, error)
}

/// 4096 ULP for x of magnitude 2^-126 to 2^126, else nothing is known.
pub(super) fn atan2(y: Interval, x: Interval) -> Interval {
    let magnitude = super::arithmetic::unary(FloatUnary::Abs, x);
    if !magnitude.within(f64::from(f32::MIN_POSITIVE), 2_f64.powi(126)) {
        return Interval::UNBOUNDED;
    }
    if x.low() < 0.0 && y.has_zero() {
        // The angle jumps from pi to -pi, and the sign of a zero may be ignored.
        return widened(-PI, PI, 4096.0);
    }
    let (low, high) = corners(y, x, libm::atan2);
    widened(low, high, 4096.0)
}
