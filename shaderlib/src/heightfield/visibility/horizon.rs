//! The horizon in one vertical plane: every cell under it, the steepest line of sight to each.

use super::Visibility;
use crate::heightfield::exact::{Axis, Quadratic};
use crate::heightfield::{Border, Heights};

impl Visibility<'_> {
    /// Rise over run of the steepest line from a point to the surface, in the direction `towards` (of length 1) and not
    /// farther than `reach` texels; infinite from the ground itself or below, which hides everything. Nothing less than 0
    /// is said: the map goes on, or far land does.
    #[must_use]
    pub fn horizon(&self, from: [f64; 3], towards: [f64; 2], reach: f64) -> f64 {
        self.horizon_above(0.0, from, towards, reach)
    }

    /// The same; nothing less than `least` is said, and where that is much the search is short.
    pub(super) fn horizon_above(&self, least: f64, from: [f64; 3], towards: [f64; 2], reach: f64) -> f64 {
        let path = Path::new(self.heights, from, towards, reach);
        path.map_or(least, |path| self.walk(path, least * self.steps) / self.steps)
    }

    fn walk(&self, path: Path, least: f64) -> f64 {
        let mut cell = path.cell;
        let (mut t, mut steepest) = (0.0, least);
        loop {
            let exits = [path.axes[0].exit(cell[0]), path.axes[1].exit(cell[1])];
            let axis = usize::from(exits[1] < exits[0]);
            let end = exits[axis].min(path.reach).max(t);
            steepest = steepest.max(rise(self.gap(&path, cell, t), t, end));
            // Nothing beyond rises higher than to the lid.
            if exits[axis] >= path.reach || self.lid - path.height <= steepest * end {
                return steepest;
            }
            cell[axis] += path.axes[axis].step();
            t = end;
        }
    }

    /// The height of the level ray above the surface, from t on.
    fn gap(&self, path: &Path, cell: [i64; 2], t: f64) -> Quadratic {
        let [x, y] = &path.axes;
        let at = [x.within(cell[0], t), y.within(cell[1], t), path.height];
        Quadratic::new(self.heights.corners(cell[0], cell[1]), at, [x.rate(), y.rate(), 0.0])
    }
}

/// A level ray.
struct Path {
    axes: [Axis; 2],
    cell: [i64; 2],
    height: f64,
    reach: f64,
}

impl Path {
    /// None where the ray is not over the map at its start, or positions reach 2^52 texels.
    fn new(heights: &Heights, [x, y, height]: [f64; 3], towards: [f64; 2], reach: f64) -> Option<Self> {
        let axes = [Axis::new(x, towards[0])?, Axis::new(y, towards[1])?];
        let cell = [axes[0].cell(0.0)?, axes[1].cell(0.0)?];
        let whole = Self { axes, cell, height, reach };
        if heights.border() == Border::Wrap {
            return Some(whole);
        }
        let last = heights.size().map(|side| i64::from(side) - 1);
        let (a, b) = (axes[0].inside(last[0])?, axes[1].inside(last[1])?);
        let cells = heights.cells().map(i64::from);
        let cell = [0, 1].map(|axis| cell[axis].clamp(0, cells[axis] - 1));
        (a.0.max(b.0) <= 0.0).then_some(Self { cell, reach: reach.min(a.1).min(b.1), ..whole })
    }
}

/// The largest −gap(t − start) / t for t in start..end: at an end, or where its derivative is 0.
fn rise(gap: Quadratic, start: f64, end: f64) -> f64 {
    if start == 0.0 && gap.constant <= 0.0 {
        return f64::INFINITY;
    }
    // −gap / t = −(square t + middle + pole / t).
    let pole = gap.constant - start * (gap.linear - gap.square * start);
    let at = |t: f64| -gap.at(t - start) / t;
    let ends = [start, end].into_iter().filter(|t| *t > 0.0).map(at);
    let crest = (pole / gap.square).sqrt();
    // A crest, and no trough, where both are positive. One that is none is no number.
    let between = (gap.square > 0.0 && (start..=end).contains(&crest)).then(|| at(crest));
    ends.chain(between).fold(f64::NEG_INFINITY, f64::max)
}
