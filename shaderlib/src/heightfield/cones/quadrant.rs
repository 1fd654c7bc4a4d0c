//! What can narrow a cone on one side of it: heights, mirrored so that this side is toward +x and +y, under their maxima.

use super::stored::Stored;
use crate::heightfield::pyramid::{Level, maxima};

/// One of the four ways to mirror the axes.
pub(super) type Mirror = [bool; 2];

/// The four quadrants.
pub(super) const MIRRORS: [Mirror; 4] = [[false, false], [true, false], [false, true], [true, true]];

/// A mirrored map: its heights, and the maxima of their quadtree.
pub(super) struct Quadrant {
    pub(super) size: [i32; 2],
    pub(super) wrap: bool,
    levels: Vec<Level<f32>>,
}

/// The steepest so far, as it is stored, and where it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Steepest<'a> {
    stored: &'a Stored,
    pub(super) code: u16,
    pub(super) at: [i32; 2],
    /// No slope up to this has another code: what is not steeper need not be looked at.
    ceiling: f64,
}

impl<'a> Steepest<'a> {
    pub(super) fn new(stored: &'a Stored, code: u16, at: [i32; 2]) -> Self {
        Self { stored, code, at, ceiling: stored.ceiling(code) }
    }
}

/// How heights narrow a cone.
pub(super) trait Rule: Sync {
    /// Whether a height that is `climb` above the apex, and no nearer than that on each axis, can be steeper than a slope.
    fn reaches(&self, climb: f64, away: [i32; 2], slope: f64) -> bool;

    /// The slope to a texel.
    fn slope(&self, quadrant: &Quadrant, apex: &Apex, texel: [i32; 2]) -> f64;
}

/// The tip of a cone: over a texel, or over the cell from there to `extent` further on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Apex {
    pub(super) at: [i32; 2],
    pub(super) extent: i32,
    pub(super) height: f64,
}

impl Apex {
    /// How far a texel is away on each axis: never less than 0.
    pub(super) fn away(&self, texel: [i32; 2]) -> [i32; 2] {
        [0, 1].map(|axis| (texel[axis] - self.at[axis] - self.extent).max(0))
    }
}

/// A node that is still to be looked at, in texels of a tile that may be the next one.
#[derive(Clone, Copy, Default)]
struct Node {
    level: u32,
    at: [i32; 2],
    tile: [i32; 2],
}

/// Nodes that wait: three of each level, and the tiles.
const WAITING: usize = 3 * 14 + 8;

impl Quadrant {
    /// Over the texels of a map, row by row.
    pub(super) fn new(size: [u32; 2], wrap: bool, heights: &[f32], mirror: Mirror) -> Self {
        let row = |y: u32| {
            let y = if mirror[1] { size[1] - 1 - y } else { y };
            &heights[(y * size[0]) as usize..][..size[0] as usize]
        };
        let mut values = Vec::with_capacity(heights.len());
        for y in 0..size[1] {
            match mirror[0] {
                true => values.extend(row(y).iter().rev()),
                false => values.extend(row(y)),
            }
        }
        Self { size: size.map(|side| side as i32), wrap, levels: maxima(Level { size, values }) }
    }

    /// The height of a texel of this tile or the next; none beyond the border of a map that ends there.
    pub(super) fn height(&self, texel: [i32; 2]) -> Option<f64> {
        let inside = [0, 1].map(|axis| match texel[axis] - self.size[axis] {
            beyond if beyond < 0 => Some(texel[axis] as u32),
            beyond if self.wrap => Some((beyond % self.size[axis]) as u32),
            _ => None,
        });
        Some(f64::from(self.levels[0].at(inside[0]?, inside[1]?)))
    }

    /// Finds what is steepest from an apex toward +x and +y, the nearest nodes first; nodes that cannot be steeper than what is
    /// known stay closed, so the code is that over all texels.
    pub(super) fn search(&self, rule: &impl Rule, apex: &Apex, known: &mut Steepest<'_>) {
        let mut waiting = [Node::default(); WAITING];
        let mut count = 0;
        let top = self.levels.len() as u32 - 1;
        let tiles: &[[i32; 2]] = if self.wrap { &[[1, 1], [0, 1], [1, 0], [0, 0]] } else { &[[0, 0]] };
        for tile in tiles {
            let tile = [0, 1].map(|axis| tile[axis] * self.size[axis]);
            waiting[count] = Node { level: top, at: [0, 0], tile };
            count += 1;
        }
        while count > 0 {
            count -= 1;
            let node = waiting[count];
            if !self.may_be_steeper(rule, apex, &node, known.ceiling) {
                continue;
            }
            if node.level == 0 {
                self.consider(rule, apex, [0, 1].map(|axis| node.tile[axis] + node.at[axis]), known);
                continue;
            }
            let finer = self.levels[node.level as usize - 1].size.map(|side| side as i32);
            for child in [[1, 1], [0, 1], [1, 0], [0, 0]] {
                let at = [0, 1].map(|axis| 2 * node.at[axis] + child[axis]);
                if at[0] < finer[0] && at[1] < finer[1] {
                    waiting[count] = Node { level: node.level - 1, at, tile: node.tile };
                    count += 1;
                }
            }
        }
    }

    fn may_be_steeper(&self, rule: &impl Rule, apex: &Apex, node: &Node, slope: f64) -> bool {
        let near = [0, 1].map(|axis| node.tile[axis] + (node.at[axis] << node.level));
        let far =
            [0, 1].map(|axis| node.tile[axis] + (((node.at[axis] + 1) << node.level) - 1).min(self.size[axis] - 1));
        if far[0] < apex.at[0] || far[1] < apex.at[1] {
            return false;
        }
        let climb = f64::from(self.levels[node.level as usize].at(node.at[0] as u32, node.at[1] as u32)) - apex.height;
        climb > 0.0 && rule.reaches(climb, apex.away(near), slope)
    }

    /// Takes a texel if it is steeper than what is known.
    pub(super) fn consider(&self, rule: &impl Rule, apex: &Apex, texel: [i32; 2], known: &mut Steepest<'_>) {
        if texel[0] < apex.at[0] || texel[1] < apex.at[1] {
            return;
        }
        let slope = rule.slope(self, apex, texel);
        if slope > known.ceiling {
            *known = Steepest::new(known.stored, known.stored.code(slope), texel);
        }
    }
}
