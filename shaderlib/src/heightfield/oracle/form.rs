//! How high a ray is above one patch, in whole numbers.

use std::cmp::Ordering;

use super::time::Time;
use super::wide;

/// The height above a patch at t, times 2^32: `constant + linear t + square t²`.
///
/// With U, V the position in the cell, Z the height and (dx, dy, dz) the direction, all in 1/256; a, b, c, d the corners
/// and e = a − b − c + d, it is 2^24 Z + lift − 2^16 (2^16 a + 2^8 (b − a) U + 2^8 (c − a) V + e U V).
///
/// The limits of [`super::Oracle`] give |b − a| < 2^16, |e| < 2^17, |dx|, |dy|, |dz| ≤ 2^24, |U|, |V| ≤ 2^26 at t = 0,
/// |Z| ≤ 2^40, |lift| ≤ 2^31. So
///
/// - |square| = 2^16 |e dx dy| < 2^81,
/// - |linear| < 2^48 + 2^16 (2 · 2^(8+16+24) + 2^17 · 2 · 2^50) < 2^85,
/// - |constant| < 2^64 + 2^31 + 2^16 (2^32 + 2 · 2^(8+16+26) + 2^(17+52)) < 2^86;
///
/// and with p, q ≤ 2^40 every factor below stays under 2^127; their products are compared in 256 bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form {
    constant: i128,
    linear: i128,
    square: i128,
}

impl Form {
    pub(super) fn new(corners: [i64; 4], at: [i64; 3], direction: [i32; 3], lift: i32) -> Self {
        let [a, b, c, d] = corners.map(i128::from);
        let ([u, v, z], [dx, dy, dz]) = (at.map(i128::from), direction.map(i128::from));
        let (x, y, both) = ((b - a) << 8, (c - a) << 8, a - b - c + d);
        let patch = (a << 16) + x * u + y * v + both * u * v;
        Self {
            constant: (z << 24) + i128::from(lift) - (patch << 16),
            linear: (dz << 24) - ((x * dx + y * dy + both * (u * dy + v * dx)) << 16),
            square: -((both * dx * dy) << 16),
        }
    }

    /// Its sign at t: that of (square p + linear q) p + constant q · q. 2^121 + 2^125, and 2^126.
    pub(super) fn sign(&self, t: Time) -> Ordering {
        let (p, q) = (t.p(), t.q());
        wide::compare(self.square * p + self.linear * q, p, -self.constant * q, q)
    }

    /// Whether it is 0 or less somewhere between two times, where it is more than 0 at both.
    ///
    /// Then it has a minimum in between, and there the discriminant is not negative. Factors: 2^85, 2^88, 2^81.
    pub(super) fn dips(&self, from: Time, to: Time) -> bool {
        self.square > 0
            && self.slope(from) < 0
            && self.slope(to) > 0
            && wide::compare(self.linear, self.linear, 4 * self.constant, self.square).is_ge()
    }

    /// A number with the sign of the slope: linear q + 2 square p. 2^125 + 2^122.
    fn slope(&self, t: Time) -> i128 {
        self.linear * t.q() + 2 * self.square * t.p()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_overflows_at_the_limits() {
        let (far, fast, top) = (1_i64 << 26, 1 << 24, 65535);
        let (last, finest) = (Time::new(1 << 40, 1 << 40).unwrap(), Time::new((1 << 40) - 1, 1 << 40).unwrap());
        for corners in [[top, 0, 0, top], [0, top, top, 0], [0, top, 0, 0]] {
            for signs in 0..64 {
                let sign = |bit: i32| 1 - 2 * (signs >> bit & 1);
                let at = [far * i64::from(sign(0)), far * i64::from(sign(1)), (1 << 40) * i64::from(sign(2))];
                let form = Form::new(corners, at, [fast * sign(3), fast * sign(4), fast * sign(5)], i32::MIN);
                let _ = (form.sign(last), form.sign(finest), form.dips(Time::ZERO, last), form.dips(finest, last));
                assert!(form.square.abs() < 1 << 81 && form.linear.abs() < 1 << 85 && form.constant.abs() < 1 << 86);
            }
        }
    }

    #[test]
    fn a_ray_that_touches_a_saddle_is_on_it_there_and_nowhere_else() {
        // Along the diagonal against the corner d: h = 65535 s (1 − s), and at s = ½ a quarter of 65535.
        let touching = |lift| Form::new([0, 0, 0, 65535], [0, 256, 65535 * 64], [256, -256, 0], lift);
        let (half, one) = (Time::new(1, 2).unwrap(), Time::new(1, 1).unwrap());
        assert_eq!(touching(0).sign(half), Ordering::Equal);
        assert_eq!([touching(1).sign(half), touching(-1).sign(half)], [Ordering::Greater, Ordering::Less]);
        assert!(touching(0).sign(Time::ZERO).is_gt() && touching(0).sign(one).is_gt());
        assert!(touching(0).dips(Time::ZERO, one) && !touching(1).dips(Time::ZERO, one));
        assert!(!touching(0).dips(Time::ZERO, Time::new(1, 3).unwrap()), "the minimum is later");
    }
}
