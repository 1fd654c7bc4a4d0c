//! What can narrow a round cone on one side of it: heights, mirrored so that this side is toward +x and +y, under their maxima.

use super::mirror::{Mirror, mirrored};
use super::stored::Stored;
use crate::heightfield::pyramid::{Level, maxima};

/// A mirrored map: its heights, and the maxima of their quadtree.
pub(super) struct Quadrant {
    size: [i32; 2],
    wrap: bool,
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

/// The tip of a cone: a texel and its height.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tip {
    pub(super) at: [i32; 2],
    pub(super) height: f64,
}

impl Tip {
    /// How far a texel is away, squared; an axis on which it lies behind counts nothing.
    fn away(&self, texel: [i32; 2]) -> f64 {
        let [x, y] = [0, 1].map(|axis| f64::from((texel[axis] - self.at[axis]).max(0)));
        x * x + y * y
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
        Self { size: size.map(|side| side as i32), wrap, levels: maxima(mirrored(size, heights, mirror)) }
    }

    /// The height of a texel of this tile or the next; none beyond the border of a map that ends there.
    fn height(&self, texel: [i32; 2]) -> Option<f64> {
        let inside = [0, 1].map(|axis| match texel[axis] - self.size[axis] {
            beyond if beyond < 0 => Some(texel[axis] as u32),
            beyond if self.wrap => Some((beyond % self.size[axis]) as u32),
            _ => None,
        });
        Some(f64::from(self.levels[0].at(inside[0]?, inside[1]?)))
    }

    /// Finds what is steepest from a tip toward +x and +y, the nearest nodes first; nodes that cannot be steeper than what is
    /// known stay closed, so the code is that over all texels.
    pub(super) fn search(&self, tip: &Tip, known: &mut Steepest<'_>) {
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
            if !self.may_be_steeper(tip, &node, known.ceiling) {
                continue;
            }
            if node.level == 0 {
                self.consider(tip, [0, 1].map(|axis| node.tile[axis] + node.at[axis]), known);
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

    fn may_be_steeper(&self, tip: &Tip, node: &Node, slope: f64) -> bool {
        let near = [0, 1].map(|axis| node.tile[axis] + (node.at[axis] << node.level));
        let far =
            [0, 1].map(|axis| node.tile[axis] + (((node.at[axis] + 1) << node.level) - 1).min(self.size[axis] - 1));
        if far[0] < tip.at[0] || far[1] < tip.at[1] {
            return false;
        }
        let climb = f64::from(self.levels[node.level as usize].at(node.at[0] as u32, node.at[1] as u32)) - tip.height;
        climb > 0.0 && climb * climb > slope * slope * tip.away(near)
    }

    /// Takes a texel if it is steeper than what is known.
    pub(super) fn consider(&self, tip: &Tip, texel: [i32; 2], known: &mut Steepest<'_>) {
        if texel[0] < tip.at[0] || texel[1] < tip.at[1] {
            return;
        }
        let climb = self.height(texel).unwrap_or(f64::NEG_INFINITY) - tip.height;
        let slope = if climb > 0.0 { climb / tip.away(texel).sqrt() } else { 0.0 };
        if slope > known.ceiling {
            *known = Steepest::new(known.stored, known.stored.round(slope), texel);
        }
    }
}
