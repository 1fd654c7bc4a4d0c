//! The oracle's walk from cell to cell.

use super::Oracle;
use super::form::Form;
use super::time::Time;
use crate::heightfield::Border;

/// A cell, counted from the origin's, and when the ray enters it. |cell| < 2^18: see [`super::limits`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) cell: [i64; 2],
    pub(super) from: Time,
}

impl Oracle<'_> {
    /// The first cell of the walk whose closed square holds a point of the ray, until then, that is not above ground.
    pub(super) fn crossing(&self, until: Time) -> Option<[i64; 2]> {
        let (start, until) = self.span(until.min(self.end))?;
        let mut place = self.place(start);
        if self.form(place.cell).sign(start).is_le() {
            return Some(place.cell);
        }
        // From here on the ray is above ground at the entry to each cell.
        loop {
            let (axis, exit) = self.exit(place.cell);
            let to = exit.map_or(until, |exit| exit.min(until));
            let form = self.form(place.cell);
            if form.sign(to).is_le() || form.dips(place.from, to) {
                return Some(place.cell);
            }
            if exit.is_none_or(|exit| exit >= until) {
                return None;
            }
            place.cell[axis] += i64::from(self.ray.direction[axis].signum());
            place.from = to;
        }
    }

    /// The times from the beginning to a later one at which there is a surface; none if there are not.
    pub(super) fn span(&self, until: Time) -> Option<(Time, Time)> {
        if self.heights.border() == Border::Wrap {
            return Some((Time::ZERO, until));
        }
        let (mut start, mut end) = (Time::ZERO, until);
        for axis in [0, 1] {
            let (first, last) = self.domain(axis);
            let rate = i64::from(self.ray.direction[axis]);
            if rate == 0 {
                ((first..=last).contains(&0)).then_some(())?;
                continue;
            }
            let (near, far) = if rate < 0 { (-last, -first) } else { (first, last) };
            (far >= 0).then_some(())?;
            start = start.max(Time::of(near.max(0), rate.abs()));
            end = end.min(Time::of(far, rate.abs()));
        }
        (start <= end).then_some((start, end))
    }

    /// From the ray's origin to the two ends of a clamped map, in 1/256.
    fn domain(&self, axis: usize) -> (i64, i64) {
        let last = i64::from(self.heights.size()[axis]) - 1;
        (-self.ray.origin[axis], (last << 8) - self.ray.origin[axis])
    }

    /// The cell at a time: 1/256 of floor(U + t d), and the last cell has the last border.
    pub(super) fn place(&self, t: Time) -> Place {
        let cell = [0, 1].map(|axis| {
            // 8 + 40 bits, 24 + 40 bits; the quotient is a cell within the limits.
            let position = i128::from(self.fraction[axis]) * t.q() + i128::from(self.ray.direction[axis]) * t.p();
            let cell = position.div_euclid(t.q() << 8) as i64;
            match self.heights.border() {
                Border::Wrap => cell,
                Border::Clamp => {
                    cell.clamp(-self.base[axis], i64::from(self.heights.cells()[axis]) - 1 - self.base[axis])
                }
            }
        });
        Place { cell, from: t }
    }

    /// The axis along which the ray leaves a cell first, x if both at once, and when; never if it is vertical.
    fn exit(&self, cell: [i64; 2]) -> (usize, Option<Time>) {
        let exit = |axis: usize| {
            let rate = i64::from(self.ray.direction[axis]);
            let plane = (cell[axis] + i64::from(rate > 0)) << 8;
            (rate != 0).then(|| Time::of(plane - self.fraction[axis], rate))
        };
        match (exit(0), exit(1)) {
            (Some(x), Some(y)) if y < x => (1, Some(y)),
            (None, y) => (1, y),
            (x, _) => (0, x),
        }
    }

    pub(super) fn form(&self, cell: [i64; 2]) -> Form {
        let [x, y] = [0, 1].map(|axis| self.base[axis] + cell[axis]);
        // Whole numbers up to 65535: a conversion loses nothing.
        let corners = self.heights.corners(x, y).map(|height| height as i64);
        let at = [0, 1].map(|axis| self.fraction[axis] - (cell[axis] << 8));
        Form::new(corners, [at[0], at[1], self.ray.origin[2]], self.ray.direction, self.lift)
    }
}
