//! The steepest way up from every texel, any way.

use rayon::prelude::*;

use super::falling::falling;
use super::map::{Cones, steps};
use super::mirror::{Mirror, mirrors, place};
use super::part::{Part, area};
use super::quadrant::{Quadrant, Steepest, Tip};
use super::stored::Stored;
use crate::heightfield::{Border, Heights};

/// The codes of all cones over the texels of some parts: of each the steepest way from its tip to a texel that counts. `done` is
/// told of each part that is, once for each of [`mirrors`].
pub(super) fn codes(heights: &Heights, stored: &Stored, parts: &[Part], done: &(dyn Fn() + Sync)) -> Vec<Vec<u16>> {
    let steps = steps(heights.texels());
    let mut codes: Vec<_> = parts.iter().map(|part| vec![stored.round(0.0); area(part)]).collect();
    for mirror in mirrors(stored.cones) {
        let side = Side::new(heights, &steps, stored, *mirror);
        codes.par_iter_mut().zip(parts).for_each(|(codes, [columns, rows])| {
            for (y, codes) in rows.clone().zip(codes.chunks_exact_mut(columns.len())) {
                side.steepen(columns.start, y, codes);
            }
            done();
        });
    }
    codes
}

/// A map toward a quadrant.
struct Side<'a> {
    size: [u32; 2],
    steps: &'a [f32],
    stored: &'a Stored,
    mirror: Mirror,
    quadrant: Quadrant,
}

impl<'a> Side<'a> {
    fn new(heights: &Heights, steps: &'a [f32], stored: &'a Stored, mirror: Mirror) -> Self {
        let (size, wrap) = (heights.size(), heights.border() == Border::Wrap);
        let quadrant = match stored.cones {
            Cones::Relaxed => Quadrant::new(size, wrap, &falling(size, wrap, steps, mirror), mirror),
            _ => Quadrant::new(size, wrap, steps, mirror),
        };
        Self { size, steps, stored, mirror, quadrant }
    }

    /// Brings the codes of a row, from a column on, up to the slopes toward the quadrant.
    fn steepen(&self, first: usize, y: usize, codes: &mut [u16]) {
        let row = &self.steps[y * self.size[0] as usize + first..][..codes.len()];
        let mut last = [0, 0];
        for index in 0..codes.len() {
            let x = if self.mirror[0] { codes.len() - 1 - index } else { index };
            let at = place([(first + x) as u32, y as u32], self.size, self.mirror).map(|at| at as i32);
            let tip = Tip { at, height: f64::from(row[x]) };
            let mut steepest = Steepest::new(self.stored, codes[x], last);
            // What was steepest from the neighbour often still is: then most nodes stay closed from the start.
            self.quadrant.consider(&tip, last, &mut steepest);
            self.quadrant.search(&tip, &mut steepest);
            last = steepest.at;
            codes[x] = steepest.code;
        }
    }
}
