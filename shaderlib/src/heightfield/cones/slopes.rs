//! The steepest way up from every tip.

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::falling::falling;
use super::map::Cones;
use super::quadrant::{Apex, MIRRORS, Mirror, Quadrant, Rule, Steepest};
use super::rules::{Round, Square};
use super::stored::Stored;
use crate::heightfield::{Border, Heights, Texels};

/// A map as the search wants it.
pub(super) struct Ground {
    cones: Cones,
    size: [u32; 2],
    wrap: bool,
    heights: Vec<f32>,
}

impl Ground {
    pub(super) fn new(heights: &Heights, cones: Cones) -> Self {
        let values = match heights.texels() {
            Texels::U8(values) => values.iter().map(|value| f32::from(*value)).collect(),
            Texels::U16(values) => values.iter().map(|value| f32::from(*value)).collect(),
            Texels::F32(values) => values.clone(),
        };
        Self { cones, size: heights.size(), wrap: heights.border() == Border::Wrap, heights: values }
    }

    fn quadrant(&self, mirror: Mirror) -> Quadrant {
        match self.cones {
            Cones::Relaxed => {
                Quadrant::new(self.size, self.wrap, &falling(self.size, self.wrap, &self.heights, mirror), mirror)
            }
            _ => Quadrant::new(self.size, self.wrap, &self.heights, mirror),
        }
    }

    /// Texel or cell (x, y) of the map, in a quadrant: where it stands and how high its tip is.
    fn apex(&self, [x, y]: [u32; 2], mirror: Mirror) -> Apex {
        let extent = i32::from(self.cones.are_square());
        let size = self.size.map(|side| side as i32);
        let first = [x, y].map(|at| at as i32);
        // A clamped map has no cell beyond its last one, and a side of 1 only one that is nowhere.
        let first =
            [0, 1].map(|axis| if self.wrap { first[axis] } else { first[axis].min((size[axis] - 1 - extent).max(0)) });
        let at = [0, 1].map(|axis| match mirror[axis] {
            true => (size[axis] - 1 - first[axis] - extent).rem_euclid(size[axis]),
            false => first[axis],
        });
        let corner = |x: i32, y: i32| {
            let at = [first[0] + x, first[1] + y];
            let at = [0, 1].map(|axis| if self.wrap { at[axis] % size[axis] } else { at[axis].min(size[axis] - 1) });
            self.heights[at[1] as usize * size[0] as usize + at[0] as usize]
        };
        let height = corner(0, 0).max(corner(extent, 0)).max(corner(0, extent)).max(corner(extent, extent));
        Apex { at, extent, height: f64::from(height) }
    }
}

/// The codes of all cones: of each the steepest way from its tip to a texel.
pub(super) fn codes(ground: &Ground, stored: &Stored, progress: &(dyn Fn(u64, u64) + Sync)) -> Vec<u16> {
    let width = ground.size[0] as usize;
    let mut codes = vec![stored.code(0.0); ground.heights.len()];
    let mirrors = match ground.cones {
        Cones::Quadrant(one) => &MIRRORS[usize::from(one % 4)..][..1],
        _ => &MIRRORS,
    };
    let (total, done) = (mirrors.len() as u64 * u64::from(ground.size[1]), AtomicU64::new(0));
    for mirror in mirrors {
        let quadrant = ground.quadrant(*mirror);
        codes.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
            if ground.cones.are_square() {
                steepen(ground, stored, &quadrant, &Square, *mirror, y as u32, row);
            } else {
                steepen(ground, stored, &quadrant, &Round, *mirror, y as u32, row);
            }
            progress(done.fetch_add(1, Ordering::Relaxed) + 1, total);
        });
    }
    codes
}

/// Brings the codes of a row up to the slopes toward a quadrant.
fn steepen(
    ground: &Ground,
    stored: &Stored,
    quadrant: &Quadrant,
    rule: &impl Rule,
    mirror: Mirror,
    y: u32,
    row: &mut [u16],
) {
    let width = row.len() as u32;
    let mut last = [0, 0];
    for x in 0..width {
        let x = if mirror[0] { width - 1 - x } else { x };
        let apex = ground.apex([x, y], mirror);
        let mut steepest = Steepest::new(stored, row[x as usize], last);
        // What was steepest from the neighbour often still is: then most nodes stay closed from the start.
        quadrant.consider(rule, &apex, last, &mut steepest);
        quadrant.search(rule, &apex, &mut steepest);
        last = steepest.at;
        row[x as usize] = steepest.code;
    }
}
