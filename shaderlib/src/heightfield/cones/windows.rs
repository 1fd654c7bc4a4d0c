//! Maxima of squares that begin at each place of a grid, and grow.

use super::mirror::Mirror;
use super::part::Part;
use crate::heightfield::pyramid::Level;

/// Such maxima for a part of a grid, and what squares reach around it.
pub(super) struct Windows {
    columns: usize,
    /// Places before the first one of a row and before the first row.
    around: usize,
    /// Of the square that is reached, each from one row and column on.
    values: Vec<f32>,
}

impl Windows {
    /// Squares of one place: of a part, and of so many places around it. What lies beyond the border is the map again, or nothing.
    pub(super) fn new(level: &Level<f32>, wrap: bool, [across, down]: &Part, around: usize) -> Self {
        let [width, height] = level.size.map(|side| side as usize);
        let columns = across.len() + 2 * around;
        let mut values = Vec::with_capacity(columns * (down.len() + 2 * around));
        let inside = |at: usize, side: usize| match at.checked_sub(around) {
            Some(at) if at < side => Some(at),
            _ => wrap.then(|| (at + around * (side - 1)) % side),
        };
        for y in down.start..down.end + 2 * around {
            let Some(y) = inside(y, height) else {
                values.resize(values.len() + columns, f32::NEG_INFINITY);
                continue;
            };
            let row = &level.values[y * width..][..width];
            let beside = |x: usize| inside(x, width).map_or(f32::NEG_INFINITY, |x| row[x]);
            values.extend((across.start..across.start + around).map(beside));
            values.extend_from_slice(&row[across.clone()]);
            values.extend((across.end + around..across.end + 2 * around).map(beside));
        }
        Self { columns, around, values }
    }

    /// The squares that begin in a row of the part, so many places before each of its own, to that side and up.
    pub(super) fn row(&self, y: usize, before: [usize; 2]) -> &[f32] {
        let [left, up] = before.map(|before| self.around - before);
        &self.values[(y + up) * self.columns + left..][..self.columns - left]
    }

    /// Of the squares of one place those that are so far away from the cells of a row, toward a quadrant: before the first
    /// corner of a cell, or behind its last.
    pub(super) fn corner(&self, y: usize, mirror: Mirror, away: [usize; 2]) -> &[f32] {
        let at = |axis: usize| if mirror[axis] { self.around - away[axis] } else { self.around + 1 + away[axis] };
        let [left, up] = [at(0), at(1)];
        &self.values[(y + up) * self.columns + left..][..self.columns - left]
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
    use std::ops::Range;

    use super::*;

    #[test]
    fn squares_hold_their_largest_value() {
        let level = Level { size: [5, 4], values: (0..20).map(|at| (at * 7 % 20) as f32).collect() };
        for wrap in [false, true] {
            for across in [0..5, 1..4] {
                let mut windows = Windows::new(&level, wrap, &[across.clone(), 1..3], 7);
                for reach in 0..=7 {
                    holds(&level, wrap, &windows, &across, reach);
                    windows.grow();
                }
            }
        }
    }

    fn holds(level: &Level<f32>, wrap: bool, windows: &Windows, across: &Range<usize>, reach: i32) {
        let places = (0..2).flat_map(|y| across.clone().map(move |x| (x as i32, y)));
        for ((x, y), [left, up]) in places.flat_map(|at| [[0, 0], [7, 0], [2, 5]].map(|before| (at, before))) {
            let [from_x, from_y] = [x - left, y + 1 - up];
            let all = (from_y..=from_y + reach).flat_map(|j| (from_x..=from_x + reach).map(move |i| (i, j)));
            let seen = all.filter(|(i, j)| wrap || (0..5).contains(i) && (0..4).contains(j));
            let value = |(i, j): (i32, i32)| level.at(i.rem_euclid(5) as u32, j.rem_euclid(4) as u32);
            let most = seen.map(value).fold(f32::NEG_INFINITY, f32::max);
            let found = windows.row(y as usize, [left as usize, up as usize])[x as usize - across.start];
            assert_eq!(found, most, "{wrap} {reach} {x} {y} {left} {up}");
        }
    }
}
