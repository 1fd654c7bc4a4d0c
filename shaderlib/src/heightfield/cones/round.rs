//! The steepest way up from every texel, any way.

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::falling::falling;
use super::map::{Cones, steps};
use super::mirror::{Mirror, mirrors, place};
use super::quadrant::{Quadrant, Steepest, Tip};
use super::stored::Stored;
use crate::heightfield::{Border, Heights};

/// The codes of all cones over texels: of each the steepest way from its tip to a texel that counts.
pub(super) fn codes(heights: &Heights, stored: &Stored, progress: &(dyn Fn(u64, u64) + Sync)) -> Vec<u16> {
    let (size, wrap, steps) = (heights.size(), heights.border() == Border::Wrap, steps(heights.texels()));
    let mut codes = vec![stored.round(0.0); steps.len()];
    let mirrors = mirrors(stored.cones);
    let (total, done) = (mirrors.len() as u64 * u64::from(size[1]), AtomicU64::new(0));
    for mirror in mirrors {
        let quadrant = match stored.cones {
            Cones::Relaxed => Quadrant::new(size, wrap, &falling(size, wrap, &steps, *mirror), *mirror),
            _ => Quadrant::new(size, wrap, &steps, *mirror),
        };
        let width = size[0] as usize;
        codes.par_chunks_mut(width).zip(steps.par_chunks(width)).enumerate().for_each(|(y, (codes, row))| {
            steepen(stored, &quadrant, size, *mirror, y as u32, row, codes);
            progress(done.fetch_add(1, Ordering::Relaxed) + 1, total);
        });
    }
    codes
}

/// Brings the codes of a row up to the slopes toward a quadrant.
fn steepen(
    stored: &Stored,
    quadrant: &Quadrant,
    size: [u32; 2],
    mirror: Mirror,
    y: u32,
    row: &[f32],
    codes: &mut [u16],
) {
    let mut last = [0, 0];
    for x in 0..size[0] {
        let x = if mirror[0] { size[0] - 1 - x } else { x };
        let at = place([x, y], size, mirror).map(|at| at as i32);
        let tip = Tip { at, height: f64::from(row[x as usize]) };
        let mut steepest = Steepest::new(stored, codes[x as usize], last);
        // What was steepest from the neighbour often still is: then most nodes stay closed from the start.
        quadrant.consider(&tip, last, &mut steepest);
        quadrant.search(&tip, &mut steepest);
        last = steepest.at;
        codes[x as usize] = steepest.code;
    }
}
