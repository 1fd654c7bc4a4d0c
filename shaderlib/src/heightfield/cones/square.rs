//! The steepest way up from every cell, by the maxima of squares.
//!
//! What stands up to `d` texels away is as steep as the highest of it at that distance, or steeper; so the steepest way up is the
//! steepest over all `d` to the highest point of the square of `d` texels, and squares grow by a comparison for each row and column.
//! Near a cell they grow texel by texel, and what is found is what there is. Farther away they grow by nodes of two, four, eight
//! texels, counted as near as they can be: there a cone may be a few hundredths steeper than it has to be, and that of one quadrant
//! is narrowed by what lies in the cell's node behind it too; it is never less steep than it has to be. All of it is f32 and in an
//! order that leaves no choice, so that a device that does the same finds the same (`hosts/relief/build_cones.wgsl`).

use rayon::prelude::*;

use super::map::steps;
use super::mirror::{Mirror, mirrors};
use super::node_row::NodeRow;
use super::part::{Part, area};
use super::rings::{Ring, rings};
use super::stored::Stored;
use super::windows::{Windows, larger, steepen};
use crate::heightfield::pyramid::{Level, maxima};
use crate::heightfield::{Border, Heights};

/// Cells along a part that does not reach from border to border: nodes of any size are whole in it, or hold all of it, as it begins
/// at a multiple of this.
pub(super) const SIDE: usize = 64;

/// The codes of all cones over the cells of some parts. `done` is told of each part that is.
pub(super) fn codes(heights: &Heights, stored: &Stored, parts: &[Part], done: &(dyn Fn() + Sync)) -> Vec<Vec<u16>> {
    let land = Land::new(heights, mirrors(stored.cones));
    let part = |part: &Part| {
        let codes = land.slopes(part).into_iter().map(|slope| stored.square(slope)).collect();
        done();
        codes
    };
    parts.par_iter().map(part).collect()
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
        let mut corners = Windows::new(&heights, wrap, &[0..width, 0..height], 1);
        corners.grow();
        let values = (0..height).flat_map(|y| &corners.row(y, [0, 0])[..width]).copied().collect();
        let tips = maxima(Level { size: heights.size, values });
        Self { mirrors, wrap, heights, tips }
    }

    /// Steps to each texel that the steepest way up from each cell of a part climbs, in f32: less than three roundings below what
    /// it is.
    fn slopes(&self, part: &Part) -> Vec<f32> {
        let tips = self.tips_of(part);
        let mut slopes = vec![0.0; area(part)];
        let levels = rings(self.wrap, self.tips[0].size);
        self.near(part, &levels[0], &tips, &mut slopes);
        self.diagonals(part, &levels[0], &tips, &mut slopes);
        for (level, rings) in levels.iter().enumerate().skip(1) {
            self.far(level, part, rings, &tips, &mut slopes);
        }
        slopes
    }

    fn tips_of(&self, [columns, rows]: &Part) -> Vec<f32> {
        let width = self.tips[0].size[0] as usize;
        let rows = self.tips[0].values.chunks_exact(width).take(rows.end).skip(rows.start);
        rows.flat_map(|row| &row[columns.clone()]).copied().collect()
    }

    /// What is in rings of texels.
    fn near(&self, part: &Part, rings: &[Ring], tips: &[f32], slopes: &mut [f32]) {
        let width = part[0].len();
        let mut windows = Windows::new(&self.tips[0], self.wrap, part, rings.len());
        for Ring { reach, share, .. } in rings {
            windows.grow();
            for (y, (slopes, tips)) in slopes.chunks_exact_mut(width).zip(tips.chunks_exact(width)).enumerate() {
                for mirror in self.mirrors {
                    steepen(slopes, tips, windows.row(y, before(*mirror, *reach)), *share);
                }
            }
        }
    }

    /// Over a cell that the diagonal crosses, from (a, a) to (a + 1, a + 1) away, surface and distance are quadratics along it, and
    /// their middle control points have to compare as well: half the sum of the two corners beside it, and a + 1/2. Everywhere
    /// else what is true at the corners of a cell is true in it.
    fn diagonals(&self, part: &Part, rings: &[Ring], tips: &[f32], slopes: &mut [f32]) {
        let width = part[0].len();
        let ground = Windows::new(&self.heights, self.wrap, part, rings.len() + 1);
        for (y, (slopes, tips)) in slopes.chunks_exact_mut(width).zip(tips.chunks_exact(width)).enumerate() {
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

    /// What lies in rings of nodes.
    fn far(&self, level: usize, part: &Part, rings: &[Ring], tips: &[f32], slopes: &mut [f32]) {
        let width = part[0].len();
        let nodes = part.clone().map(|range| range.start >> level..range.end.div_ceil(1 << level));
        let most = rings.last().map_or(0, |ring| ring.reach);
        let mut windows = Windows::new(&self.tips[level], self.wrap, &nodes, most);
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
