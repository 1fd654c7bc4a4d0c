//! Intervals of `f32`, with directed rounding from `f64`.

/// All numbers from `low` to `high`; or anything at all, NaN included, if they are infinite.
///
/// Where it holds a subnormal number it holds zero too, for implementations may flush.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Interval {
    low: f32,
    high: f32,
}

impl Interval {
    /// Accepts anything.
    pub const UNBOUNDED: Self = Self { low: f32::NEG_INFINITY, high: f32::INFINITY };

    /// One number; anything, if it is not finite.
    pub fn point(value: f32) -> Self {
        Self::new(value, value)
    }

    /// All numbers between two, in order; anything, if one of them is not finite.
    pub fn new(low: f32, high: f32) -> Self {
        // Not `is_infinite`: a NaN is unbounded as well.
        if !(low.is_finite() && high.is_finite()) {
            return Self::UNBOUNDED;
        }
        let low = if low > 0.0 && low < f32::MIN_POSITIVE { 0.0 } else { low };
        let high = if high < 0.0 && high > -f32::MIN_POSITIVE { 0.0 } else { high };
        Self { low, high }
    }

    /// All results that a correctly rounded operation may give whose exact results lie between two.
    ///
    /// An `f64` that is off by half a unit in its last place may still stand exactly on an `f32`: use
    /// [`outside`](Self::outside) where the bounds are not exact.
    pub fn rounded(low: f64, high: f64) -> Self {
        Self::new(down(low), up(high))
    }

    /// As [`rounded`](Self::rounded), for bounds that are known up to an error: each is moved outward by that.
    pub fn outside(low: f64, high: f64, error_low: f64, error_high: f64) -> Self {
        Self::rounded(low - error_low, high + error_high)
    }

    /// The smallest number.
    pub fn low(&self) -> f32 {
        self.low
    }

    /// The largest number.
    pub fn high(&self) -> f32 {
        self.high
    }

    pub(super) fn bounds(&self) -> (f64, f64) {
        (f64::from(self.low), f64::from(self.high))
    }

    /// Whether it accepts anything.
    pub fn is_unbounded(&self) -> bool {
        self.low == f32::NEG_INFINITY
    }

    /// Whether it is a single number.
    pub fn is_point(&self) -> bool {
        self.low == self.high
    }

    /// Whether a result is acceptable.
    pub fn accepts(&self, value: f32) -> bool {
        self.is_unbounded() || self.low <= value && value <= self.high
    }

    /// Whether a number that need not be an `f32` lies inside.
    pub fn holds(&self, value: f64) -> bool {
        self.is_unbounded() || f64::from(self.low) <= value && value <= f64::from(self.high)
    }

    /// The smallest interval that holds both.
    pub fn join(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Whether all of it lies between two numbers.
    pub(super) fn within(&self, low: f64, high: f64) -> bool {
        f64::from(self.low) >= low && f64::from(self.high) <= high
    }

    /// Whether zero may be in it.
    pub(super) fn has_zero(&self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }
}

/// The largest `f32` that is not above x.
pub(super) fn down(x: f64) -> f32 {
    let nearest = x as f32;
    if f64::from(nearest) > x { nearest.next_down() } else { nearest }
}

/// The smallest `f32` that is not below x.
pub(super) fn up(x: f64) -> f32 {
    -down(-x)
}

/// One unit in the last place of an `f32` at x (WGSL 15.7.4): the distance of the two that enclose it.
pub(super) fn ulp(x: f64) -> f64 {
    let magnitude = x.abs().min(f64::from(f32::MAX));
    if magnitude < f64::from(f32::MIN_POSITIVE) {
        return SMALLEST;
    }
    let nearest = magnitude as f32;
    let below = f64::from(nearest) - f64::from(nearest.next_down());
    let above = f64::from(nearest.next_up().min(f32::MAX)) - f64::from(nearest);
    match f64::from(nearest).total_cmp(&magnitude) {
        std::cmp::Ordering::Equal => below,
        std::cmp::Ordering::Less => above,
        std::cmp::Ordering::Greater => below,
    }
}

/// The smallest subnormal `f32`, 2^-149.
const SMALLEST: f64 = 1.401_298_464_324_817e-45;

/// The error of so many units in the last place, anywhere on the way from x to zero: units shrink on it, their size in
/// proportion to x does not grow beyond 2^-23.
pub(super) fn relative(units: f64, x: f64) -> f64 {
    units * (x.abs() * f64::from(f32::EPSILON) + SMALLEST)
}

#[cfg(test)]
mod tests {
    use super::{Interval, down, ulp, up};

    #[test]
    fn rounds_outward_and_only_where_needed() {
        assert_eq!((down(0.5), up(0.5)), (0.5, 0.5));
        assert_eq!((down(0.1), up(0.1)), (0.099_999_994, 0.1));
        assert_eq!((down(1e300), up(1e300)), (f32::MAX, f32::INFINITY));
        assert_eq!(down(-1e-300), -f32::from_bits(1));
        assert!(Interval::rounded(0.0, 1e300).is_unbounded());
        assert!(Interval::rounded(f64::NAN, 1.0).is_unbounded());
    }

    #[test]
    fn a_subnormal_number_may_be_zero() {
        assert!(Interval::point(1e-40).accepts(0.0));
        assert!(Interval::point(-1e-40).accepts(0.0));
        assert!(!Interval::point(1e-30).accepts(0.0));
    }

    #[test]
    fn the_last_place_is_that_of_the_enclosing_floats() {
        assert_eq!(ulp(1.5), f64::from(f32::EPSILON));
        assert_eq!(ulp(1.0), f64::from(f32::EPSILON) / 2.0);
        assert_eq!(ulp(1.0 + 1e-12), f64::from(f32::EPSILON));
        assert_eq!(ulp(-3.0), 2.0 * f64::from(f32::EPSILON));
        assert_eq!(ulp(0.0), f64::from(f32::from_bits(1)));
        assert_eq!(ulp(1e300), f64::from(f32::MAX) - f64::from(f32::MAX.next_down()));
    }
}
