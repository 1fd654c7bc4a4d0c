//! Times as fractions.

use std::cmp::Ordering;

/// Numerators and denominators reach this far.
pub(super) const LARGEST: i64 = 1 << 40;

/// A time on a ray as a fraction: 0 or later. Its parts reach 2^40.
#[derive(Clone, Copy, Debug)]
pub struct Time {
    p: i64,
    q: i64,
}

impl Time {
    /// The beginning of a ray.
    pub const ZERO: Self = Self { p: 0, q: 1 };

    /// p / q, if p is in 0..2^40 and q in 1..2^40.
    #[must_use]
    pub fn new(p: i64, q: i64) -> Option<Self> {
        ((0..=LARGEST).contains(&p) && (1..=LARGEST).contains(&q)).then_some(Self { p, q })
    }

    /// Of a distance and a rate that is not 0. The walk asks only for what lies ahead, within its own smaller limits.
    pub(super) fn of(distance: i64, rate: i64) -> Self {
        Self { p: distance * rate.signum(), q: rate.abs() }
    }

    pub(super) fn p(self) -> i128 {
        i128::from(self.p)
    }

    pub(super) fn q(self) -> i128 {
        i128::from(self.q)
    }
}

impl Ord for Time {
    fn cmp(&self, other: &Self) -> Ordering {
        // Each product has 80 bits.
        (self.p() * other.q()).cmp(&(other.p() * self.q()))
    }
}

impl PartialOrd for Time {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Eq for Time {}

impl PartialEq for Time {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn are_ordered_as_fractions() {
        let time = |p, q| Time::new(p, q).unwrap();
        assert_eq!(time(2, 6), time(1, 3));
        assert!(time(LARGEST - 1, LARGEST) < time(1, 1) && time(1, LARGEST) > Time::ZERO);
        assert_eq!(Time::of(-6, -4), time(3, 2));
    }

    #[test]
    fn have_limits() {
        assert!([(-1, 1), (1, 0), (LARGEST + 1, 1), (1, LARGEST + 1)].iter().all(|(p, q)| Time::new(*p, *q).is_none()));
    }
}
