//! Which cones a change may have reached.
//!
//! A cone is as steep as the steepest of all that counts for it. So as long as what has changed is less steep from its tip than what is
//! stored, before and after, something else decides, and it stays. How steep what has changed is at most, its highest point and its
//! distance tell: the least distance at which rings count it, as [`rings`](super::rings()) counts nodes as near as they can be.

mod counted;
#[cfg(test)]
mod tests;

use std::ops::Range;

pub use self::counted::shares;
use super::map::Cones;
use super::part::{Part, codes, squares, with_any};
use super::stored::Stored;
use crate::heightfield::Heights;

/// More than what is found in f32 may be off: a part of it, and where f32 lacks digits.
const ROUNDING: f64 = 1e-6;
const LEAST: f64 = f32::MIN_POSITIVE as f64;

/// The codes of all parts in which a change of some texels may have reached a cone. `is_reached` is asked whether a slope with a
/// code would be as steep as what is stored at a place, or steeper.
pub(crate) fn changed(
    stored: &Stored,
    (before, after): (&Heights, &Heights),
    texels: &[[Range<u32>; 2]],
    is_reached: &(impl Fn([usize; 2], u16) -> bool + Sync),
) -> Vec<(Part, Vec<u16>)> {
    let changes: Vec<Change> = texels.iter().map(|texels| Change::new(stored.cones, [before, after], texels)).collect();
    let parts = with_any(squares(after, stored.cones), &|at| {
        changes.iter().any(|change| change.reaches(stored, after, at, is_reached))
    });
    let codes = codes(after, stored, &parts, &|| ());
    parts.into_iter().zip(codes).collect()
}

/// How high the tip of a cone is.
pub(crate) fn tip(heights: &Heights, cones: Cones, at: [usize; 2]) -> f64 {
    let [x, y] = at.map(|at| at as i64);
    match cones.are_square() {
        true => heights.corners(x, y).into_iter().fold(f64::MIN, f64::max),
        false => heights.height(x, y),
    }
}

/// A rectangle of what has changed.
struct Change {
    /// The highest of it and of the ground beside it, before or after.
    highest: f64,
    /// One over the least distance at which it can count for a column, and for a row: for a place the smaller of both holds.
    shares: [Vec<f64>; 2],
}

impl Change {
    fn new(cones: Cones, maps: [&Heights; 2], texels: &[Range<u32>; 2]) -> Self {
        let [columns, rows] = texels.clone().map(|range| i64::from(range.start) - 1..i64::from(range.end) + 1);
        let around = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
        let highest = around.flat_map(|(x, y)| maps.map(|map| map.height(x, y))).fold(f64::MIN, f64::max);
        Self { highest, shares: shares(cones, maps[1].border(), maps[1].size(), std::slice::from_ref(texels)) }
    }

    /// Whether the cone that stands at a place may be another: what has changed is there, or as steep from its tip as the cone.
    fn reaches(
        &self,
        stored: &Stored,
        after: &Heights,
        at: [usize; 2],
        is_reached: &impl Fn([usize; 2], u16) -> bool,
    ) -> bool {
        let share = self.shares[0][at[0]].min(self.shares[1][at[1]]);
        let from = |tip: f64| {
            // In f32, as it is found: the way up may be longer than the longest f32.
            let climb = f64::from(self.highest as f32 - tip as f32);
            climb > 0.0 && is_reached(at, stored.code(climb * share * (1.0 + ROUNDING) + LEAST))
        };
        // A tip is no lower than the texel, and most texels are asked no more.
        share.is_infinite() || from(after.texel(at)) && from(tip(after, stored.cones, at))
    }
}
