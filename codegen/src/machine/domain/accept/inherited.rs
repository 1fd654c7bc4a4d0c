//! Functions whose error is inherited from a formula (WGSL 15.7.4.1).

use super::super::{FloatBinary, FloatTernary, FloatUnary};
use super::arithmetic::{add, binary as apply, constant, divide, inverse_sqrt, multiply, unary as of};
use super::interval::{Interval, relative};

/// One bounded operand.
pub(super) fn unary(op: FloatUnary, x: Interval) -> Interval {
    let one = Interval::point(1.0);
    let half = Interval::point(0.5);
    match op {
        FloatUnary::Sqrt => sqrt(x),
        FloatUnary::Tan => both(of(FloatUnary::Sin, x), of(FloatUnary::Cos, x), divide),
        FloatUnary::Sinh => both(exponentials(x, FloatBinary::Subtract), half, multiply),
        FloatUnary::Cosh => both(exponentials(x, FloatBinary::Add), half, multiply),
        FloatUnary::Tanh => {
            let ratio = both(unary(FloatUnary::Sinh, x), unary(FloatUnary::Cosh, x), divide);
            worse(ratio, x, libm::tanh, 1e-5)
        }
        FloatUnary::Asin if x.within(-1.0, 1.0) => {
            worse(both(x, cathetus(x), |y, x| apply(FloatBinary::Atan2, y, x)), x, libm::asin, 6.81e-5)
        }
        FloatUnary::Acos if x.within(-1.0, 1.0) => {
            worse(both(cathetus(x), x, |y, x| apply(FloatBinary::Atan2, y, x)), x, libm::acos, 6.77e-5)
        }
        FloatUnary::Asin | FloatUnary::Acos => Interval::UNBOUNDED,
        FloatUnary::Asinh => logarithm_with_root(x, one),
        FloatUnary::Acosh => logarithm_with_root(x, Interval::point(-1.0)),
        FloatUnary::Atanh => {
            let ratio = both(add(one, x), apply(FloatBinary::Subtract, one, x), divide);
            both(then(ratio, |ratio| of(FloatUnary::Log, ratio)), half, multiply)
        }
        FloatUnary::Radians => multiply(x, constant(std::f64::consts::PI / 180.0)),
        FloatUnary::Degrees => multiply(x, constant(180.0 / std::f64::consts::PI)),
        other => unreachable!("{other:?} has an accuracy of its own"),
    }
}

/// Two bounded operands.
pub(super) fn binary(op: FloatBinary, a: Interval, b: Interval) -> Interval {
    if op == FloatBinary::Pow {
        let product = both(b, of(FloatUnary::Log2, a), multiply);
        return then(product, |product| of(FloatUnary::Exp2, product));
    }
    let whole = then(divide(a, b), |quotient| of(FloatUnary::Trunc, quotient));
    both(a, both(b, whole, multiply), |a, product| apply(FloatBinary::Subtract, a, product))
}

/// Three bounded operands.
pub(super) fn ternary(op: FloatTernary, a: Interval, b: Interval, c: Interval) -> Interval {
    match op {
        FloatTernary::Clamp => {
            let raised = apply(FloatBinary::Max, a, b);
            let clamped = apply(FloatBinary::Min, raised, c);
            if b.high() <= c.low() {
                return clamped;
            }
            // With crossed bounds an implementation may take the median of the three instead.
            clamped.join(apply(FloatBinary::Max, apply(FloatBinary::Min, a, c), b))
        }
        FloatTernary::Fma => both(multiply(a, b), c, add),
        FloatTernary::Mix => mix(a, b, c),
        FloatTernary::SmoothStep => smooth_step(a, b, c),
    }
}

/// `a * (1 - t) + b * t`, or `a + (b - a) * t`: the conformance tests accept both.
fn mix(a: Interval, b: Interval, t: Interval) -> Interval {
    let rest = apply(FloatBinary::Subtract, Interval::point(1.0), t);
    let precise = both(both(a, rest, multiply), multiply(b, t), add);
    let step = both(apply(FloatBinary::Subtract, b, a), t, multiply);
    let imprecise = both(a, step, add);
    precise.join(imprecise)
}

/// `t * t * (3 - 2 * t)` with `t = clamp((x - low) / (high - low), 0, 1)`.
fn smooth_step(low: Interval, high: Interval, x: Interval) -> Interval {
    let along = apply(FloatBinary::Subtract, x, low);
    let t = both(along, apply(FloatBinary::Subtract, high, low), divide);
    then(t, |t| {
        let (from, to) = of(FloatUnary::Saturate, t).bounds();
        // The polynomial rises on 0..1. It takes three roundings of 2^-23 each and a product by two, which is exact.
        let value = |t: f64| t * t * (3.0 - 2.0 * t);
        Interval::outside(value(from), value(to), relative(4.0, value(from)), relative(4.0, value(to)))
    })
}

/// In any order; a fused product is inside the rounded one.
pub(super) fn dot(a: &[Interval], b: &[Interval]) -> Interval {
    let products: Vec<Interval> = a.iter().zip(b).map(|(a, b)| both(*a, *b, multiply)).collect();
    sum(&products)
}

/// As [`dot`] with itself.
pub(super) fn square_sum(x: &[Interval]) -> Interval {
    let squares: Vec<Interval> = x.iter().map(|x| then(*x, |x| of(FloatUnary::Square, x))).collect();
    sum(&squares)
}

/// `1 / inverseSqrt(x)`.
///
/// That says nothing of 0, and the conformance tests accept anything there. But an implementation for which the root of
/// 0 were not 0 would break every `length`, and there is none: 0 is what is accepted.
fn sqrt(x: Interval) -> Interval {
    let root = |x: f32| both(Interval::point(1.0), inverse_sqrt(Interval::point(x)), divide);
    match (x.low(), x.high()) {
        (0.0, 0.0) => Interval::point(0.0),
        (0.0, high) => then(root(high), |root| Interval::new(0.0, root.high())),
        _ => both(Interval::point(1.0), inverse_sqrt(x), divide),
    }
}

/// Every way to add the terms two by two.
fn sum(terms: &[Interval]) -> Interval {
    if let [a, b] = terms {
        return both(*a, *b, add);
    }
    let mut all: Option<Interval> = None;
    for i in 0..terms.len() {
        for j in i + 1..terms.len() {
            let rest = terms.iter().enumerate().filter(|(k, _)| *k != i && *k != j).map(|(_, term)| *term);
            let terms: Vec<Interval> = std::iter::once(both(terms[i], terms[j], add)).chain(rest).collect();
            let total = sum(&terms);
            all = Some(all.map_or(total, |all| all.join(total)));
        }
    }
    all.unwrap_or_default()
}

/// `exp(x) + exp(-x)` or their difference.
fn exponentials(x: Interval, op: FloatBinary) -> Interval {
    let rising = of(FloatUnary::Exp, x);
    let falling = of(FloatUnary::Exp, of(FloatUnary::Negate, x));
    both(rising, falling, |rising, falling| apply(op, rising, falling))
}

/// `sqrt(1 - x * x)`.
fn cathetus(x: Interval) -> Interval {
    let rest = apply(FloatBinary::Subtract, Interval::point(1.0), multiply(x, x));
    unary(FloatUnary::Sqrt, rest)
}

/// `log(x + sqrt(x * x + offset))`.
fn logarithm_with_root(x: Interval, offset: Interval) -> Interval {
    let root = then(both(multiply(x, x), offset, add), |square| unary(FloatUnary::Sqrt, square));
    then(both(x, root, add), |sum| of(FloatUnary::Log, sum))
}

/// The worse of a formula and an absolute error: an implementation may have either.
fn worse(formula: Interval, x: Interval, f: fn(f64) -> f64, error: f64) -> Interval {
    let (low, high) = x.bounds();
    let (a, b) = (f(low), f(high));
    formula.join(Interval::outside(a.min(b), a.max(b), error, error))
}

/// Applies an operation to bounded operands only.
fn both(a: Interval, b: Interval, f: impl Fn(Interval, Interval) -> Interval) -> Interval {
    if a.is_unbounded() || b.is_unbounded() { Interval::UNBOUNDED } else { f(a, b) }
}

/// As [`both`], for one operand.
fn then(x: Interval, f: impl Fn(Interval) -> Interval) -> Interval {
    if x.is_unbounded() { x } else { f(x) }
}
