//! The reference in f64: every cell that a ray passes over, one quadratic in each.
//!
//! The cell is integer state. The times of the borders come from their whole numbers, each by itself, and an interval
//! begins where the last one ended: no part of the ray is skipped, nothing is nudged, and no error adds up.

mod axis;
mod path;
mod quadratic;

use path::Path;

pub(super) use axis::Axis;
pub(super) use quadratic::Quadratic;

use super::{Heights, Hit, Ray};

/// Cells after which a walk ends: as many as the largest map has.
const STEPS: u32 = 1 << 26;

/// The first t of a range at which a ray is on the surface or below: the ground is solid, so that a ray which begins in
/// it hits at once, and one that comes from beyond a clamped map's border may hit its side.
///
/// The range may be infinite; what is decided is a path over at most 2^26 cells, below the highest texel if the map
/// wraps. Beyond that, and where numbers are infinite or none, or positions reach 2^52 texels, nothing is hit.
#[must_use]
pub fn first_hit(heights: &Heights, ray: &Ray, range: (f64, f64)) -> Option<Hit> {
    let path = Path::new(heights, ray, range)?;
    let hit = walk(heights, &path, STEPS)?;
    Some(Hit { t: path.time(hit.t).max(range.0).min(range.1), ..hit })
}

/// Whether a ray from a point in a direction meets no ground in a range of t. A point of the surface is ground itself:
/// a shadow's range begins a little past it.
#[must_use]
pub fn visible(heights: &Heights, from: [f64; 3], towards: [f64; 3], range: (f64, f64)) -> bool {
    first_hit(heights, &Ray { origin: from, direction: towards }, range).is_none()
}

fn walk(heights: &Heights, path: &Path, steps: u32) -> Option<Hit> {
    let mut cell = first_cell(heights, path)?;
    let mut t = path.start;
    for _ in 0..steps {
        let exits = [path.axes[0].exit(cell[0]), path.axes[1].exit(cell[1])];
        let axis = usize::from(exits[1] < exits[0]);
        // A border that rounding has put before the entry is crossed at once.
        let end = exits[axis].min(path.end).max(t);
        if let Some(s) = above(heights, path, cell, t).first(end - t) {
            return Some(hit(path, cell, t + s));
        }
        if exits[axis] >= path.end {
            return None;
        }
        cell[axis] += path.axes[axis].step();
        t = end;
    }
    None
}

/// Where the walk begins. A clamped map's last border belongs to its last cell: there is none behind it.
fn first_cell(heights: &Heights, path: &Path) -> Option<[i64; 2]> {
    let [x, y] = [path.axes[0].cell(path.start)?, path.axes[1].cell(path.start)?];
    let [columns, rows] = heights.cells().map(i64::from);
    Some(match heights.border() {
        super::Border::Wrap => [x, y],
        super::Border::Clamp => [x.clamp(0, columns - 1), y.clamp(0, rows - 1)],
    })
}

fn above(heights: &Heights, path: &Path, cell: [i64; 2], t: f64) -> Quadratic {
    let [x, y] = &path.axes;
    let at = [x.within(cell[0], t), y.within(cell[1], t), t.mul_add(path.climb, path.height)];
    Quadratic::new(heights.corners(cell[0], cell[1]), at, [x.rate(), y.rate(), path.climb])
}

fn hit(path: &Path, cell: [i64; 2], t: f64) -> Hit {
    let uv = [0, 1].map(|axis| path.axes[axis].within(cell[axis], t).clamp(0.0, 1.0));
    Hit { t, cell, uv }
}

#[cfg(test)]
mod tests;
