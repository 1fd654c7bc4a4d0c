//! The steepest way up from every cell, by the maxima of squares.
//!
//! What stands up to `d` texels away is as steep as the highest of it at that distance, or steeper; so the steepest way up is the
//! steepest over all `d` to the highest point of the square of `d` texels, and squares grow by a comparison for each row and column.
//! Near a cell they grow texel by texel, and what is found is what there is. Farther away they grow by nodes of two, four, eight
//! texels, counted as near as they can be: there a cone may be a few hundredths steeper than it has to be, and that of one quadrant
//! is narrowed by what lies in the cell's node behind it too; it is never less steep than it has to be. All of it is f32 and in an
//! order that leaves no choice, so that a device that does the same finds the same (`hosts/relief/build_cones.wgsl`).

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::map::steps;
use super::mirror::{Mirror, mirrors};
use super::node_row::NodeRow;
use super::rings::{Ring, rings};
use super::stored::Stored;
use super::windows::{Windows, larger, steepen};
use crate::heightfield::pyramid::{Level, maxima};
use crate::heightfield::{Border, Heights};

/// Rows of cells to a task at least, and rows of nodes.
const BAND: [usize; 2] = [64, 8];

/// The codes of all cones over cells.
pub(super) fn codes(heights: &Heights, stored: &Stored, progress: &(dyn Fn(u64, u64) + Sync)) -> Vec<u16> {
    let land = Land::new(heights, mirrors(stored.cones));
    let (total, tasks) = (land.tasks(), AtomicU64::new(0));
    let slopes = land.slopes(&|| progress(tasks.fetch_add(1, Ordering::Relaxed) + 1, total));
    let [width, height] = heights.size();
    let [columns, rows] = heights.cells();
    let texels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
    // Where no cell begins, it is that of the one before.
    let cells = texels.map(|[x, y]| (y.min(rows - 1) * width + x.min(columns - 1)) as usize);
    cells.map(|cell| stored.square(slopes[cell])).collect()
}

/// A map and the quadrants that count.
struct Land {
    mirrors: &'static [Mirror],
    wrap: bool,
    heights: Level<f32>,
    /// The tips of the cells, and the largest of nodes of them. A map that ends has a last column and row whose cells are none:
    /// they hold nothing that the cells before them do not.
    tips: Vec<Level<f32>>,
}

impl Land {
    fn new(heights: &Heights, mirrors: &'static [Mirror]) -> Self {
        let wrap = heights.border() == Border::Wrap;
        let heights = Level { size: heights.size(), values: steps(heights.texels()) };
        let [width, height] = heights.size.map(|side| side as usize);
        let mut corners = Windows::new(&heights, wrap, 0..height, 1);
        corners.grow();
        let values = (0..height).flat_map(|y| &corners.row(y, [0, 0])[..width]).copied().collect();
        let tips = maxima(Level { size: heights.size, values });
        Self { mirrors, wrap, heights, tips }
    }

    /// Steps to each texel that the steepest way up from each cell climbs, in f32: less than three roundings below what it is.
    /// `done` is told of each task that is.
    fn slopes(&self, done: &(dyn Fn() + Sync)) -> Vec<f32> {
        let [width, height] = self.tips[0].size.map(|side| side as usize);
        let levels = rings(self.wrap, self.tips[0].size);
        let mut slopes = vec![0.0; width * height];
        slopes.par_chunks_mut(width * band(0)).enumerate().for_each(|(at, slopes)| {
            self.near(at * band(0), &levels[0], slopes);
            self.diagonals(at * band(0), &levels[0], slopes);
            done();
        });
        for (level, rings) in levels.iter().enumerate().skip(1) {
            slopes.par_chunks_mut((width * band(level)) << level).enumerate().for_each(|(at, slopes)| {
                self.far(level, at * band(level), rings, slopes);
                done();
            });
        }
        slopes
    }

    /// Tasks of [`Self::slopes`].
    fn tasks(&self) -> u64 {
        let size = self.tips[0].size;
        let levels = 0..rings(self.wrap, size).len();
        levels.map(|level| (size[1] as usize).div_ceil(band(level) << level) as u64).sum()
    }

    /// The tips from a row on, row by row.
    fn tips_from(&self, row: usize) -> impl Iterator<Item = &[f32]> {
        let width = self.tips[0].size[0] as usize;
        self.tips[0].values[row * width..].chunks_exact(width)
    }

    /// Of rows from one on: what is in rings of texels.
    fn near(&self, from: usize, rings: &[Ring], slopes: &mut [f32]) {
        let width = self.tips[0].size[0] as usize;
        let mut windows = Windows::new(&self.tips[0], self.wrap, from..from + slopes.len() / width, rings.len());
        for Ring { reach, share, .. } in rings {
            windows.grow();
            for (y, (slopes, tips)) in slopes.chunks_exact_mut(width).zip(self.tips_from(from)).enumerate() {
                for mirror in self.mirrors {
                    steepen(slopes, tips, windows.row(y, before(*mirror, *reach)), *share);
                }
            }
        }
    }

    /// Over a cell that the diagonal crosses, from (a, a) to (a + 1, a + 1) away, surface and distance are quadratics along it, and
    /// their middle control points have to compare as well: half the sum of the two corners beside it, and a + 1/2. Everywhere
    /// else what is true at the corners of a cell is true in it.
    fn diagonals(&self, from: usize, rings: &[Ring], slopes: &mut [f32]) {
        let width = self.tips[0].size[0] as usize;
        let rows = from..from + slopes.len() / width;
        let ground = Windows::new(&self.heights, self.wrap, rows, rings.len() + 1);
        for (y, (slopes, tips)) in slopes.chunks_exact_mut(width).zip(self.tips_from(from)).enumerate() {
            for (mirror, ring) in self.mirrors.iter().flat_map(|mirror| rings.iter().map(move |ring| (*mirror, ring))) {
                let beside = ground.corner(y, mirror, [ring.reach, ring.reach - 1]);
                let below = ground.corner(y, mirror, [ring.reach - 1, ring.reach]);
                for (((slope, tip), beside), below) in slopes.iter_mut().zip(tips).zip(beside).zip(below) {
                    let climb = larger(0.0, beside - tip) + larger(0.0, below - tip);
                    *slope = larger(*slope, climb * ring.middle);
                }
            }
        }
    }

    /// Of the rows of nodes from one on: what lies in rings of nodes.
    fn far(&self, level: usize, from: usize, rings: &[Ring], slopes: &mut [f32]) {
        let width = self.tips[0].size[0] as usize;
        let tips = &self.tips[0].values[(from << level) * width..][..slopes.len()];
        let rows = from..from + (slopes.len() / width).div_ceil(1 << level);
        let most = rings.last().map_or(0, |ring| ring.reach);
        let mut windows = Windows::new(&self.tips[level], self.wrap, rows, most);
        let of_rows = slopes.chunks_mut(width << level).zip(tips.chunks(width << level));
        let mut rows: Vec<_> = of_rows.map(|(slopes, tips)| NodeRow::new(level, width, tips, slopes)).collect();
        let mut reach = 0;
        for ring in rings {
            (reach..ring.reach).for_each(|_| windows.grow());
            reach = ring.reach;
            for (y, row) in rows.iter_mut().enumerate() {
                for mirror in self.mirrors {
                    row.steepen(windows.row(y, before(*mirror, reach)), ring.share);
                }
            }
        }
    }
}

/// How far before a place the square toward a quadrant begins.
fn before(mirror: Mirror, reach: usize) -> [usize; 2] {
    mirror.map(|mirrored| if mirrored { reach } else { 0 })
}

/// Rows of nodes to a task.
fn band(level: usize) -> usize {
    (BAND[0] >> level).max(BAND[1])
}
