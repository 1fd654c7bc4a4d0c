//! The steepest way up from every cell, by the maxima of squares.
//!
//! What stands up to `d` texels away is as steep as the highest of it at that distance, or steeper; so the steepest way up is the
//! steepest over all `d` to the highest point of the square of `d` texels, and squares grow by a comparison for each row and column.
//! Near a cell they grow texel by texel, and what is found is what there is. Farther away they grow by nodes of two, four, eight
//! texels, counted as near as they can be: there a cone may be a few hundredths steeper than it has to be, and that of one quadrant
//! is narrowed by what lies in the cell's node behind it too; it is never less steep than it has to be. All of it is f32 and in an
//! order that leaves no choice, so that a device that does the same finds the same (`hosts/relief/cones.wgsl`).

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::map::steps;
use super::mirror::{Mirror, mirrors};
use super::node_row::NodeRow;
use super::stored::Stored;
use super::windows::{Windows, larger, steepen};
use crate::heightfield::pyramid::{Level, maxima};
use crate::heightfield::{Border, Heights};

/// Texels up to which squares grow one by one, and nodes of any size.
const NEAR: usize = 32;

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
        let farthest = NEAR.min(width.max(height) - 1);
        let mut slopes = vec![0.0; width * height];
        slopes.par_chunks_mut(width * band(0)).enumerate().for_each(|(at, slopes)| {
            self.near(at * band(0), farthest, slopes);
            self.diagonals(at * band(0), farthest, slopes);
            done();
        });
        for (level, rings) in rings(self.wrap, self.tips[0].size) {
            slopes.par_chunks_mut((width * band(level)) << level).enumerate().for_each(|(at, slopes)| {
                self.far(level, at * band(level), &rings, slopes);
                done();
            });
        }
        slopes
    }

    /// Tasks of [`Self::slopes`].
    fn tasks(&self) -> u64 {
        let size = self.tips[0].size;
        let levels = std::iter::once(0).chain(rings(self.wrap, size).into_iter().map(|(level, _)| level));
        levels.map(|level| (size[1] as usize).div_ceil(band(level) << level) as u64).sum()
    }

    /// The tips from a row on, row by row.
    fn tips_from(&self, row: usize) -> impl Iterator<Item = &[f32]> {
        let width = self.tips[0].size[0] as usize;
        self.tips[0].values[row * width..].chunks_exact(width)
    }

    /// Of rows from one on: what is up to so many texels away.
    fn near(&self, from: usize, farthest: usize, slopes: &mut [f32]) {
        let width = self.tips[0].size[0] as usize;
        let mut windows = Windows::new(&self.tips[0], self.wrap, from..from + slopes.len() / width, farthest);
        for away in 1..=farthest {
            windows.grow();
            for (y, (slopes, tips)) in slopes.chunks_exact_mut(width).zip(self.tips_from(from)).enumerate() {
                for mirror in self.mirrors {
                    steepen(slopes, tips, windows.row(y, before(*mirror, away)), 1.0 / away as f32);
                }
            }
        }
    }

    /// Over a cell that the diagonal crosses, from (a, a) to (a + 1, a + 1) away, surface and distance are quadratics along it, and
    /// their middle control points have to compare as well: half the sum of the two corners beside it, and a + 1/2. Everywhere
    /// else what is true at the corners of a cell is true in it.
    fn diagonals(&self, from: usize, farthest: usize, slopes: &mut [f32]) {
        let width = self.tips[0].size[0] as usize;
        let rows = from..from + slopes.len() / width;
        let ground = Windows::new(&self.heights, self.wrap, rows, farthest + 1);
        for (y, (slopes, tips)) in slopes.chunks_exact_mut(width).zip(self.tips_from(from)).enumerate() {
            for (mirror, away) in self.mirrors.iter().flat_map(|mirror| (0..farthest).map(move |away| (*mirror, away)))
            {
                let beside = ground.corner(y, mirror, [away + 1, away]);
                let below = ground.corner(y, mirror, [away, away + 1]);
                let share = 1.0 / (2 * away + 1) as f32;
                for (((slope, tip), beside), below) in slopes.iter_mut().zip(tips).zip(beside).zip(below) {
                    let climb = larger(0.0, beside - tip) + larger(0.0, below - tip);
                    *slope = larger(*slope, climb * share);
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

/// Squares of nodes: how often they have grown, and one over the least distance of what is new in them.
struct Ring {
    reach: usize,
    share: f32,
}

/// The rings of each level of nodes, by which everything is reached that is farther than [`NEAR`].
fn rings(wrap: bool, size: [u32; 2]) -> Vec<(usize, Vec<Ring>)> {
    let size = size.map(|side| side as usize);
    let farthest = size[0].max(size[1]) - 1;
    let (mut covered, mut levels) = (NEAR, Vec::new());
    while covered < farthest {
        let level = levels.len() + 1;
        let node = 1 << level;
        // The last node of a map that wraps may be a part of one: beyond it everything is nearer by what is missing.
        let lack = size.map(|side| if wrap { side.next_multiple_of(node) - side } else { 0 });
        let lack = lack[0].max(lack[1]);
        let reaches = (covered + lack) / node + 1..=NEAR.min((farthest + lack).div_ceil(node));
        covered = reaches.end() * node - lack;
        // Half a texel for the middles of diagonals.
        let share = |reach: usize| 1.0 / (((reach - 1) * node - lack) as f32 - 0.5);
        levels.push((level, reaches.map(|reach| Ring { reach, share: share(reach) }).collect()));
    }
    levels
}
