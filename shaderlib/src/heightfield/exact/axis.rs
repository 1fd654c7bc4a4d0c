//! One horizontal coordinate of a ray, split so that no tile is too far away.

/// `base + fraction + t rate`: the whole cells apart from the fraction, which keeps all its bits wherever the ray is.
#[derive(Clone, Copy, Debug)]
pub(in crate::heightfield) struct Axis {
    base: i64,
    fraction: f64,
    rate: f64,
}

/// Positions from here on lack the bits for a place within a cell.
const FARTHEST: f64 = (1_u64 << 52) as f64;

impl Axis {
    /// Of a coordinate and its rate, unless it begins too far away.
    pub(in crate::heightfield) fn new(origin: f64, rate: f64) -> Option<Self> {
        let base = origin.floor();
        (origin.abs() < FARTHEST).then_some(Self { base: base as i64, fraction: origin - base, rate })
    }

    pub(in crate::heightfield) fn rate(&self) -> f64 {
        self.rate
    }

    /// +1 or −1: the way from cell to cell.
    pub(in crate::heightfield) fn step(&self) -> i64 {
        if self.rate < 0.0 { -1 } else { 1 }
    }

    /// When the coordinate is a whole number: one rounding of the distance, one of the quotient. Not for rate 0.
    pub(in crate::heightfield) fn time(&self, plane: i64) -> f64 {
        ((plane - self.base) as f64 - self.fraction) / self.rate
    }

    /// When the ray leaves a cell: never, if it keeps the coordinate.
    pub(in crate::heightfield) fn exit(&self, cell: i64) -> f64 {
        if self.rate == 0.0 { f64::INFINITY } else { self.time(cell + i64::from(self.rate > 0.0)) }
    }

    /// From the corner of a cell. The product is not rounded, so that the result has no more than an ulp of 1 as error.
    pub(in crate::heightfield) fn within(&self, cell: i64, t: f64) -> f64 {
        t.mul_add(self.rate, -((cell - self.base) as f64)) + self.fraction
    }

    /// The cell at t, to begin a walk in; none too far away. After that a cell is state, stepped and never looked for:
    /// rounding may give a neighbour here, whose patch is the same on the border.
    pub(in crate::heightfield) fn cell(&self, t: f64) -> Option<i64> {
        let way = t.mul_add(self.rate, self.fraction).floor();
        (way.abs() < FARTHEST).then_some(self.base + way as i64)
    }

    /// The times at which the coordinate is in 0..last; none where it never is.
    pub(in crate::heightfield) fn inside(&self, last: i64) -> Option<(f64, f64)> {
        if self.rate == 0.0 {
            let place = self.base as f64 + self.fraction;
            return (0.0..=last as f64).contains(&place).then_some((f64::NEG_INFINITY, f64::INFINITY));
        }
        let (first, second) = (self.time(0), self.time(last));
        Some((first.min(second), first.max(second)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_tiles_away_no_bit_is_lost() {
        let (near, far) = (Axis::new(0.7, -0.3).unwrap(), Axis::new(8_192e6 + 0.5, 1.5).unwrap());
        assert_eq!((far.cell(0.0), far.within(8_192_000_000, 1e-9)), (Some(8_192_000_000), 0.5 + 1.5e-9));
        assert_eq!((near.cell(3.0), near.step(), near.exit(0)), (Some(-1), -1, 0.7 / 0.3));
        assert!(Axis::new(f64::NAN, 1.0).is_none() && Axis::new(1e300, 1.0).is_none());
        assert!(near.cell(1e300).is_none());
    }

    #[test]
    fn a_fraction_below_the_border_may_round_to_it_but_is_continued_there() {
        let axis = Axis::new(-1e-300, 1.0).unwrap();
        assert_eq!((axis.cell(0.0), axis.within(0, 0.0)), (Some(0), 0.0));
    }
}
