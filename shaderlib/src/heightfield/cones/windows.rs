//! Maxima of squares that begin at each place of a grid, and grow.

use crate::heightfield::pyramid::Level;

/// A band of rows of such maxima.
pub(super) struct Windows {
    columns: usize,
    /// Of the square that is reached, each from one row and column on.
    values: Vec<f32>,
}

impl Windows {
    /// Squares of one place, from a row on: so many rows, for squares that grow so many times. What lies beyond the last column
    /// and row is the first again, or nothing.
    pub(super) fn new(level: &Level<f32>, wrap: bool, from: usize, rows: usize, reach: usize) -> Self {
        let [width, height] = level.size.map(|side| side as usize);
        let columns = width + reach;
        let mut values = Vec::with_capacity(columns * (rows + reach));
        for y in from..from + rows + reach {
            let row = if wrap { Some(y % height) } else { Some(y).filter(|y| *y < height) };
            let end = values.len() + columns;
            if let Some(row) = row {
                let row = &level.values[row * width..][..width];
                values.extend_from_slice(row);
                while wrap && values.len() < end {
                    values.extend_from_slice(&row[..width.min(end - values.len())]);
                }
            }
            values.resize(end, f32::NEG_INFINITY);
        }
        Self { columns, values }
    }

    /// A row of the band.
    pub(super) fn row(&self, y: usize) -> &[f32] {
        &self.values[y * self.columns..][..self.columns]
    }

    /// The squares, a column and a row larger. Of the rows the last is gone.
    pub(super) fn grow(&mut self) {
        let columns = self.columns;
        // A copy, since in place a comparison would wait for the one before it.
        let mut right = vec![0.0; columns - 1];
        let mut widen = |row: &mut [f32]| {
            right.copy_from_slice(&row[1..]);
            raise(row, &right);
        };
        widen(&mut self.values[..columns]);
        for at in (columns..self.values.len()).step_by(columns) {
            let (done, rest) = self.values.split_at_mut(at);
            widen(&mut rest[..columns]);
            raise(&mut done[at - columns..], &rest[..columns]);
        }
        self.values.truncate(self.values.len() - columns);
    }
}

fn raise(row: &mut [f32], other: &[f32]) {
    for (value, other) in row.iter_mut().zip(other) {
        *value = larger(*value, *other);
    }
}

/// One instruction, where `f32::max` takes several to mind what is no number.
pub(super) fn larger(a: f32, b: f32) -> f32 {
    if b > a { b } else { a }
}

/// Brings slopes up to those from tips to what stands highest at a distance, of which one over it is the share.
pub(super) fn steepen(slopes: &mut [f32], tips: &[f32], highest: &[f32], share: f32) {
    for ((slope, tip), highest) in slopes.iter_mut().zip(tips).zip(highest) {
        *slope = larger(*slope, (highest - tip) * share);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_hold_their_largest_value() {
        let level = Level { size: [5, 4], values: (0..20).map(|at| (at * 7 % 20) as f32).collect() };
        for wrap in [false, true] {
            let mut windows = Windows::new(&level, wrap, 1, 2, 3);
            for reach in 0..=3 {
                for (x, y) in (0..2).flat_map(|y| (0..5).map(move |x| (x, y))) {
                    let all = (0..=reach).flat_map(|j| (0..=reach).map(move |i| (x + i, y + 1 + j)));
                    let seen = all.filter(|(i, j)| wrap || *i < 5 && *j < 4);
                    let most = seen.map(|(i, j)| level.at(i % 5, j % 4)).fold(f32::MIN, f32::max);
                    assert_eq!(windows.row(y as usize)[x as usize], most, "{wrap} {reach} {x} {y}");
                }
                windows.grow();
            }
        }
    }
}
