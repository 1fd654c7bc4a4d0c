//! A whole pyramid at once: in bands of rows that go through several levels while they are in the cache.

use rayon::prelude::*;

use super::level::Level;
use super::reduce::{Extreme, Height, node_row, nodes};

/// Levels that a band goes through: its last has one row.
const LEVELS: usize = 6;
/// Rows of the finest level to a band.
const ROWS: usize = 1 << (LEVELS - 1);

/// Fills all levels; `finest` fills a row of the first by its number.
pub(super) fn build<E: Extreme, T: Height>(levels: &mut [Level<T>], finest: impl Fn(u32, &mut [T]) + Sync) {
    let widths: Vec<usize> = levels.iter().map(|level| level.size[0] as usize).collect();
    let banded = levels.len().min(LEVELS);
    bands(&mut levels[..banded]).par_iter_mut().enumerate().for_each(|(index, band)| {
        for (y, row) in band[0].chunks_exact_mut(widths[0]).enumerate() {
            finest((index * ROWS + y) as u32, row);
        }
        for level in 1..band.len() {
            let (finer, coarser) = band.split_at_mut(level);
            halve::<E, T>(finer[level - 1], widths[level - 1], coarser[0], widths[level]);
        }
    });
    for level in banded..levels.len() {
        let (finer, coarser) = levels.split_at_mut(level);
        let whole = coarser[0].whole();
        nodes::<E, T>(&finer[level - 1], &mut coarser[0], &whole);
    }
}

/// The parts of each level that a band has. Every level has as many: so many rows fewer as there are rows to a band fewer.
fn bands<T>(levels: &mut [Level<T>]) -> Vec<Vec<&mut [T]>> {
    let count = (levels[0].size[1] as usize).div_ceil(ROWS);
    let mut bands: Vec<Vec<&mut [T]>> = (0..count).map(|_| Vec::new()).collect();
    for (index, level) in levels.iter_mut().enumerate() {
        let part = level.size[0] as usize * (ROWS >> index);
        for (band, rows) in bands.iter_mut().zip(level.values.chunks_mut(part)) {
            band.push(rows);
        }
    }
    bands
}

/// A band's rows of a level, from its rows of the finer one: only the last band can have an odd number of them.
fn halve<E: Extreme, T: Height>(finer: &[T], width: usize, coarser: &mut [T], columns: usize) {
    let last = finer.len() / width - 1;
    let row = |y: usize| &finer[y.min(last) * width..][..width];
    for (y, nodes) in coarser.chunks_exact_mut(columns).enumerate() {
        node_row::<E, T>(row(2 * y), row(2 * y + 1), 0, nodes);
    }
}
