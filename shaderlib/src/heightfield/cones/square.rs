//! The steepest way up from every cell toward one quadrant, by the maxima of squares.
//!
//! What stands up to `d` texels away is as steep as the highest of it at that distance, or steeper; so the steepest way up is the
//! steepest over all `d` to the highest point of the square of `d` texels, and squares grow by a comparison for each row and column.
//! Near a cell they grow texel by texel, and what is found is what there is. Farther away they grow by nodes of two, four, eight
//! texels, counted as near as they can be: there a cone may be a few hundredths steeper than it has to be, and that of one quadrant
//! is narrowed by what lies in the cell's node behind it too; it is never less steep than it has to be.

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::map::steps;
use super::mirror::{Mirror, mirrored, mirrors, place};
use super::node_row::NodeRow;
use super::stored::Stored;
use super::windows::{Windows, larger, steepen};
use crate::heightfield::pyramid::{Level, maxima};
use crate::heightfield::{Border, Heights};

/// Texels up to which squares grow one by one, and nodes of any size.
const NEAR: usize = 32;

/// Rows of cells to a task at least, and rows of nodes.
const BAND: [usize; 2] = [64, 8];

/// More than slopes in f32 lack: the roundings of a difference, of one over a distance, and of their product.
const ROUNDING: f64 = 1.0 / (1_u32 << 22) as f64;

/// The codes of all cones over cells.
pub(super) fn codes(heights: &Heights, stored: &Stored, progress: &(dyn Fn(u64, u64) + Sync)) -> Vec<u16> {
    let (size, steps, mirrors) = (heights.size(), steps(heights.texels()), mirrors(stored.cones));
    let (total, tasks) = (mirrors.len() as u64 * Land::tasks(heights), AtomicU64::new(0));
    let done = || progress(tasks.fetch_add(1, Ordering::Relaxed) + 1, total);
    let mut codes = vec![stored.code(0.0); steps.len()];
    for mirror in mirrors {
        let slopes = Land::new(heights, &steps, *mirror).slopes(&done);
        codes.par_chunks_mut(size[0] as usize).enumerate().for_each(|(y, codes)| {
            for (x, code) in codes.iter_mut().enumerate() {
                let cell = first(heights, [x as u32, y as u32]);
                let [x, y] = place(cell, size, *mirror, true).map(|at| at as usize);
                *code = stored.code(f64::from(slopes[y * size[0] as usize + x]) * (1.0 + ROUNDING)).max(*code);
            }
        });
    }
    codes
}

/// The cell of a texel: where none begins, the last one before it.
fn first(heights: &Heights, texel: [u32; 2]) -> [u32; 2] {
    let cells = heights.cells();
    [0, 1].map(|axis| texel[axis].min(cells[axis] - 1))
}

/// The map as a quadrant sees it.
pub(super) struct Land {
    wrap: bool,
    /// The heights; beyond their last column and row come those that a diagonal asks for.
    ground: Windows,
    /// The tips of the cells, and the largest of nodes of them. A map that ends has a last column and row whose cells are none:
    /// they hold nothing that the cells before them do not.
    tips: Vec<Level<f32>>,
}

impl Land {
    pub(super) fn new(heights: &Heights, texels: &[f32], mirror: Mirror) -> Self {
        let level = mirrored(heights.size(), texels, mirror);
        let wrap = heights.border() == Border::Wrap;
        let [width, height] = level.size.map(|side| side as usize);
        let mut corners = Windows::new(&level, wrap, 0, height, 1);
        corners.grow();
        let values = (0..height).flat_map(|y| &corners.row(y)[..width]).copied().collect();
        let ground = Windows::new(&level, wrap, 0, height, NEAR + 2);
        Self { wrap, ground, tips: maxima(Level { size: level.size, values }) }
    }

    /// Steps to each texel that the steepest way up from each cell climbs, in f32: less than three roundings below what it is.
    /// `done` is told of each task that is.
    pub(super) fn slopes(&self, done: &(dyn Fn() + Sync)) -> Vec<f32> {
        let [width, height] = self.tips[0].size.map(|side| side as usize);
        let farthest = width.max(height) - 1;
        let mut slopes = vec![0.0; width * height];
        slopes.par_chunks_mut(width * band(0)).enumerate().for_each(|(at, slopes)| {
            self.near(at * band(0), NEAR.min(farthest), slopes);
            done();
        });
        for (level, rings) in rings(self.wrap, [width, height]) {
            slopes.par_chunks_mut((width * band(level)) << level).enumerate().for_each(|(at, slopes)| {
                self.far(level, at * band(level), &rings, slopes);
                done();
            });
        }
        slopes
    }

    /// Tasks of [`Self::slopes`].
    pub(super) fn tasks(heights: &Heights) -> u64 {
        let [width, height] = heights.size().map(|side| side as usize);
        let wrap = heights.border() == Border::Wrap;
        let levels = std::iter::once(0).chain(rings(wrap, [width, height]).into_iter().map(|(level, _)| level));
        levels.map(|level| height.div_ceil(band(level) << level) as u64).sum()
    }

    /// Of rows from one on: what is up to so many texels away.
    fn near(&self, from: usize, farthest: usize, slopes: &mut [f32]) {
        let width = self.tips[0].size[0] as usize;
        let rows = slopes.len() / width;
        let tips = |row: usize| &self.tips[0].values[(from + row) * width..][..width];
        let mut windows = Windows::new(&self.tips[0], self.wrap, from, rows, farthest);
        for away in 1..=farthest {
            windows.grow();
            let share = 1.0 / away as f32;
            for (row, slopes) in slopes.chunks_exact_mut(width).enumerate() {
                steepen(slopes, tips(row), windows.row(row), share);
            }
        }
        for (row, slopes) in slopes.chunks_exact_mut(width).enumerate() {
            (0..farthest).for_each(|away| self.diagonal(from + row, away, tips(row), slopes));
        }
    }

    /// Over a cell that the diagonal crosses, from (a, a) to (a + 1, a + 1) away, surface and distance are quadratics along it, and
    /// their middle control points have to compare as well: half the sum of the two corners beside it, and a + 1/2. Everywhere
    /// else what is true at the corners of a cell is true in it.
    fn diagonal(&self, row: usize, away: usize, tips: &[f32], slopes: &mut [f32]) {
        let (right, below) =
            (&self.ground.row(row + away + 1)[away + 2..], &self.ground.row(row + away + 2)[away + 1..]);
        let share = 1.0 / (2 * away + 1) as f32;
        for (((slope, tip), right), below) in slopes.iter_mut().zip(tips).zip(right).zip(below) {
            let climb = larger(0.0, right - tip) + larger(0.0, below - tip);
            *slope = larger(*slope, climb * share);
        }
    }

    /// Of the rows of nodes from one on: what lies in rings of nodes.
    fn far(&self, level: usize, from: usize, rings: &[Ring], slopes: &mut [f32]) {
        let width = self.tips[0].size[0] as usize;
        let tips = &self.tips[0].values[(from << level) * width..][..slopes.len()];
        let rows = (slopes.len() / width).div_ceil(1 << level);
        let most = rings.last().map_or(0, |ring| ring.reach);
        let mut windows = Windows::new(&self.tips[level], self.wrap, from, rows, most);
        let of_rows = slopes.chunks_mut(width << level).zip(tips.chunks(width << level));
        let mut rows: Vec<_> = of_rows.map(|(slopes, tips)| NodeRow::new(level, width, tips, slopes)).collect();
        let mut reach = 0;
        for ring in rings {
            (reach..ring.reach).for_each(|_| windows.grow());
            reach = ring.reach;
            rows.iter_mut().enumerate().for_each(|(y, row)| row.steepen(windows.row(y), ring.share));
        }
    }
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
fn rings(wrap: bool, size: [usize; 2]) -> Vec<(usize, Vec<Ring>)> {
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
