//! Parts of a map whose cones are found together.

use std::ops::Range;

use rayon::prelude::*;

use super::map::Cones;
use super::mirror::mirrors;
use super::stored::Stored;
use super::{round, square};
use crate::heightfield::Heights;

/// Columns and rows of cells, or of texels.
pub(crate) type Part = [Range<usize>; 2];

/// How many there are in a part.
pub(super) fn area([columns, rows]: &Part) -> usize {
    columns.len() * rows.len()
}

/// Columns and rows of all that cones stand on: cells, or texels.
pub(crate) fn standing(heights: &Heights, cones: Cones) -> [usize; 2] {
    let all = if cones.are_square() { heights.cells() } else { heights.size() };
    all.map(|side| side as usize)
}

/// All of a map, in bands of rows.
pub(super) fn bands(heights: &Heights, cones: Cones) -> Vec<Part> {
    let all = standing(heights, cones);
    parts(all, [all[0], if cones.are_square() { square::SIDE } else { 1 }])
}

/// All of a map, in squares: small ones where each cone is looked for by itself.
pub(super) fn squares(heights: &Heights, cones: Cones) -> Vec<Part> {
    parts(standing(heights, cones), [if cones.are_square() { square::SIDE } else { 8 }; 2])
}

/// The parts of so many columns and rows whose sides are the given ones, or what is left at the far ends.
fn parts(all: [usize; 2], sides: [usize; 2]) -> Vec<Part> {
    let along = |axis: usize| {
        let (side, step) = (all[axis], sides[axis]);
        (0..side).step_by(step).map(move |start| start..(start + step).min(side))
    };
    along(1).flat_map(|rows| along(0).map(move |columns| [columns, rows.clone()])).collect()
}

/// How often [`codes`] is done with a part.
pub(super) fn turns(cones: Cones) -> u64 {
    if cones.are_square() { 1 } else { mirrors(cones).len() as u64 }
}

/// The codes of the cones in some parts, found on all cores.
pub(super) fn codes(heights: &Heights, stored: &Stored, parts: &[Part], done: &(dyn Fn() + Sync)) -> Vec<Vec<u16>> {
    let codes = if stored.cones.are_square() { square::codes } else { round::codes };
    codes(heights, stored, parts, done)
}

/// The parts in which one of a part's places answers.
pub(super) fn with_any(parts: Vec<Part>, is_one: &(impl Fn([usize; 2]) -> bool + Sync)) -> Vec<Part> {
    let any = |[columns, rows]: &Part| rows.clone().any(|y| columns.clone().any(|x| is_one([x, y])));
    parts.into_par_iter().filter(any).collect()
}

/// Visits each texel of an image over a part of so many cones, with the cell of its cone and that cone's code: behind the last one it
/// is that again.
pub(crate) fn each(
    part: &Part,
    standing: [usize; 2],
    size: [u32; 2],
    codes: &[u16],
    mut visit: impl FnMut([usize; 2], [u32; 2], u16),
) {
    let [across, down] = [0, 1].map(|axis| {
        let is_last = part[axis].end == standing[axis];
        part[axis].start..if is_last { size[axis] as usize } else { part[axis].end }
    });
    for (x, y) in down.flat_map(|y| across.clone().map(move |x| (x, y))) {
        let cell = [x.min(part[0].end - 1), y.min(part[1].end - 1)];
        let code = codes[(cell[1] - part[1].start) * part[0].len() + cell[0] - part[0].start];
        visit([x, y], cell.map(|at| at as u32), code);
    }
}
