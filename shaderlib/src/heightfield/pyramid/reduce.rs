//! Rows of extremes: of cells from texels, and of nodes from the finer level.

use rayon::prelude::*;

use super::level::{Level, Region};

/// Which of two values bounds a node.
pub(super) trait Extreme: Sync {
    /// The bound of both.
    fn of<T: PartialOrd>(a: T, b: T) -> T;
}

/// The larger value.
pub(super) struct Max;
/// The smaller value.
pub(super) struct Min;

impl Extreme for Max {
    #[inline(always)]
    fn of<T: PartialOrd>(a: T, b: T) -> T {
        if b > a { b } else { a }
    }
}

impl Extreme for Min {
    #[inline(always)]
    fn of<T: PartialOrd>(a: T, b: T) -> T {
        if b < a { b } else { a }
    }
}

/// Rows to a task: less would cost more in passing it on than it takes.
const ROWS: usize = 16;

/// What a height is to a pyramid.
pub(super) trait Height: Copy + Default + PartialOrd + Send + Sync {}

impl<T: Copy + Default + PartialOrd + Send + Sync> Height for T {}

/// The extremes of the cells in a region, from the texels at their corners.
pub(super) fn cells<E: Extreme, T: Height>(texels: &[T], size: [u32; 2], into: &mut Level<T>, region: &Region) {
    rows(into, region, |y, from, row| cell_row::<E, T>(texels, size, y, from, row));
}

/// The extremes of the nodes in a region, each of two by two of the finer level, or of what there is of them.
pub(super) fn nodes<E: Extreme, T: Height>(finer: &Level<T>, into: &mut Level<T>, region: &Region) {
    let last = finer.size[1] - 1;
    rows(into, region, |y, from, row| {
        node_row::<E, T>(finer.row(2 * y), finer.row((2 * y + 1).min(last)), from, row);
    });
}

/// A row of cells, from column `from` on. Beyond the last texel comes the first or, where there are as many cells as texels
/// only because there is one, itself.
pub(super) fn cell_row<E: Extreme, T: Height>(
    texels: &[T],
    [width, height]: [u32; 2],
    y: u32,
    from: usize,
    row: &mut [T],
) {
    let width = width as usize;
    let below = if y + 1 == height { 0 } else { y + 1 };
    let [above, below] = [y, below].map(|y| &texels[y as usize * width..][..width]);
    let inner = row.len().min((width - 1).saturating_sub(from));
    let (inside, border) = row.split_at_mut(inner);
    let pairs = above[from..].windows(2).zip(below[from..].windows(2));
    for (value, (a, b)) in inside.iter_mut().zip(pairs) {
        *value = E::of(E::of(a[0], b[0]), E::of(a[1], b[1]));
    }
    let both = |x: usize| E::of(above[x], below[x]);
    for value in border {
        *value = E::of(both(width - 1), both(0));
    }
}

/// A row of nodes, from column `from` on, of the two rows of the finer level under it.
pub(super) fn node_row<E: Extreme, T: Height>(above: &[T], below: &[T], from: usize, row: &mut [T]) {
    let width = above.len();
    let whole = row.len().min((width / 2).saturating_sub(from));
    let (inside, border) = row.split_at_mut(whole);
    let pairs = above[2 * from..].chunks_exact(2).zip(below[2 * from..].chunks_exact(2));
    for (value, (a, b)) in inside.iter_mut().zip(pairs) {
        *value = E::of(E::of(a[0], b[0]), E::of(a[1], b[1]));
    }
    for value in border {
        *value = E::of(above[width - 1], below[width - 1]);
    }
}

/// Fills the rows of a region: `fill` gets the row's number, the first column, and what to fill.
fn rows<T: Send>(into: &mut Level<T>, region: &Region, fill: impl Fn(u32, usize, &mut [T]) + Sync) {
    let [columns, lines] = region.clone();
    let width = into.size[0] as usize;
    let part = &mut into.values[lines.start as usize * width..lines.end as usize * width];
    part.par_chunks_mut(width).with_min_len(ROWS).enumerate().for_each(|(index, row)| {
        fill(
            lines.start + index as u32,
            columns.start as usize,
            &mut row[columns.start as usize..columns.end as usize],
        );
    });
}
