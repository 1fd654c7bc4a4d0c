//! How high a ray is above one bilinear patch.

/// The height at s past the entry to a cell: a polynomial of degree 2, because the patch is bilinear.
#[derive(Clone, Copy, Debug)]
pub(in crate::heightfield) struct Quadratic {
    pub(in crate::heightfield) constant: f64,
    pub(in crate::heightfield) linear: f64,
    pub(in crate::heightfield) square: f64,
}

impl Quadratic {
    /// Over the patch through `corners`, from a point `at` (in the cell, and its height) along a direction.
    pub(in crate::heightfield) fn new(corners: [f64; 4], at: [f64; 3], direction: [f64; 3]) -> Self {
        let ([a, b, c, d], [u, v, z], [dx, dy, dz]) = (corners, at, direction);
        let (x, y, both) = (b - a, c - a, (a - b) + (d - c));
        Self {
            constant: (z - a) - (x * u + y * v + both * u * v),
            linear: dz - (x + both * v) * dx - (y + both * u) * dy,
            square: -both * dx * dy,
        }
    }

    /// The first s in 0..end at which the ray is on the patch or below.
    pub(in crate::heightfield) fn first(&self, end: f64) -> Option<f64> {
        if self.constant <= 0.0 {
            return Some(0.0);
        }
        let within = self.roots().into_iter().filter(|root| (0.0..=end).contains(root));
        // Below at the end: there is a root, and only rounding can have moved it out of the cell.
        within.reduce(f64::min).or_else(|| (self.at(end) <= 0.0).then_some(end))
    }

    /// At s.
    pub(in crate::heightfield) fn at(&self, s: f64) -> f64 {
        self.constant + s * (self.linear + s * self.square)
    }

    /// Both roots, none of them by subtracting what is nearly equal. One that is none is infinite or no number.
    fn roots(&self) -> [f64; 2] {
        let sum = -0.5 * (self.linear + self.discriminant().sqrt().copysign(self.linear));
        [self.constant / sum, sum / self.square]
    }

    /// b² − 4ac to nearly full precision (Kahan), for rays that touch.
    fn discriminant(&self) -> f64 {
        let (four, square) = (4.0 * self.constant, self.square);
        let product = four * square;
        let lost = (-four).mul_add(square, product);
        self.linear.mul_add(self.linear, -product) + lost
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first(constant: f64, linear: f64, square: f64, end: f64) -> Option<f64> {
        Quadratic { constant, linear, square }.first(end)
    }

    #[test]
    fn finds_the_smaller_root_in_the_interval() {
        assert_eq!(first(2.0, -3.0, 1.0, 9.0), Some(1.0), "in and out again: above at both ends");
        assert_eq!(first(2.0, 1.0, -3.0, 9.0), Some(1.0), "the other root lies behind");
        assert_eq!(first(1.0, 0.0, -1.0, 9.0), Some(1.0));
        assert_eq!(first(4.0, -4.0, 1.0, 9.0), Some(2.0), "touches");
        assert_eq!(first(3.0, -1.5, 0.0, f64::INFINITY), Some(2.0), "a line");
        assert_eq!(first(-1.0, 1.0, 0.0, 0.0), Some(0.0), "below from the beginning");
    }

    #[test]
    fn a_change_of_sign_is_never_lost_to_rounding() {
        // The root rounds to the next number after the end, where the line is 0 to the last bit.
        let (constant, end) = (0.1 * 3.0, 0.047_619_047_619_047_62);
        assert!(constant / 6.3 > end && constant - 6.3 * end == 0.0);
        assert_eq!(first(constant, -6.3, 0.0, end), Some(end));
    }

    #[test]
    fn roots_that_are_close_are_told_apart() {
        let near = 2_f64.powi(-27);
        assert_eq!(first(1.0 + 2.0 * near, -2.0 * (1.0 + near), 1.0, 9.0), Some(1.0), "the other is 1 + 2 near");
    }

    #[test]
    fn finds_nothing_where_nothing_is() {
        assert_eq!(first(2.0, -3.0, 1.0, 0.5), None);
        assert_eq!(first(5.0, -4.0, 1.0, 9.0), None, "passes above");
        assert_eq!(first(2.0, 3.0, 1.0, 9.0), None, "both roots behind");
        assert_eq!(first(1.0, 0.0, 0.0, f64::INFINITY), None, "at a constant height");
    }
}
