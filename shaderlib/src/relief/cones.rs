//! Cones and their tips as one image.

use rayon::prelude::*;

use super::placed::{Plane, Words};
use crate::heightfield::cones::{ConeMap, Cones};
use crate::heightfield::{Border, Heights, Texels};

/// The cones of a map and of its coarser mips; each mip is given by its size and texels, filled up to powers of two. A texel holds
/// the height of a cone's tip and the code of [`ConeMap`].
pub(super) fn plane<'a>(
    heights: &Heights,
    mips: impl Iterator<Item = ([u32; 2], &'a [u16])>,
    cones: Cones,
    progress: &(dyn Fn(u64, u64) + Sync),
) -> Plane {
    let (size, border) = (heights.size(), heights.border());
    let mips: Vec<_> = mips.collect();
    let images = mips.iter().map(|(filled, texels)| {
        // A map that wraps is filled already; one that does not has one mip.
        let size = if border == Border::Wrap { *filled } else { size };
        let rows = texels.chunks_exact(filled[0] as usize).take(size[1] as usize);
        let own = rows.flat_map(|row| &row[..size[0] as usize]).copied().collect();
        let mip = Heights::new(size, border, Texels::U16(own)).expect("no larger than the map, and whole rows");
        image(&mip, *filled, cones, progress)
    });
    Plane { size: mips[0].0, words: Words::Rg16(images.collect()) }
}

fn image(
    heights: &Heights,
    [width, height]: [u32; 2],
    cones: Cones,
    progress: &(dyn Fn(u64, u64) + Sync),
) -> Vec<[u16; 2]> {
    let map = ConeMap::new(heights, cones, progress);
    let [columns, rows] = map.size;
    let mut image = vec![[0; 2]; width as usize * height as usize];
    image.par_chunks_mut(width as usize).enumerate().for_each(|(y, row)| {
        let y = (y as u32).min(rows - 1);
        for (x, texel) in row.iter_mut().enumerate() {
            let x = (x as u32).min(columns - 1);
            *texel = [tip(heights, cones, x, y), map.codes[(y * columns + x) as usize]];
        }
    });
    image
}

/// How high the tip of a cone is: at most 65535, as the heights are.
fn tip(heights: &Heights, cones: Cones, x: u32, y: u32) -> u16 {
    match cones {
        Cones::Step | Cones::Relaxed => heights.height(x.into(), y.into()) as u16,
        Cones::Robust => {
            let [columns, rows] = heights.cells();
            let corners = heights.corners(x.min(columns - 1).into(), y.min(rows - 1).into());
            corners.into_iter().fold(0.0, f64::max) as u16
        }
    }
}
