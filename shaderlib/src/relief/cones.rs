//! Cones and their tips as one image.

use rayon::prelude::*;

use super::patches;
use super::plane::{Plane, Words};
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
    let mips: Vec<_> = mips.collect();
    Plane { size: mips[0].0, words: Words::Rg16(images(heights, mips.into_iter(), cones, progress)) }
}

/// The tips and codes of each mip.
fn images<'a>(
    heights: &Heights,
    mips: impl Iterator<Item = ([u32; 2], &'a [u16])>,
    cones: Cones,
    progress: &(dyn Fn(u64, u64) + Sync),
) -> Vec<Vec<[u16; 2]>> {
    let (size, border) = (heights.size(), heights.border());
    let images = mips.map(|(filled, texels)| {
        // A map that wraps is filled already; one that does not has one mip.
        let size = if border == Border::Wrap { filled } else { size };
        let rows = texels.chunks_exact(filled[0] as usize).take(size[1] as usize);
        let own = rows.flat_map(|row| &row[..size[0] as usize]).copied().collect();
        let mip = Heights::new(size, border, Texels::U16(own)).expect("no larger than the map, and whole rows");
        image(&mip, filled, cones, progress)
    });
    images.collect()
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

/// Robust cones in words, the tip's height below the code: those of all mips in one image, where patches stand.
pub(super) fn words<'a>(
    heights: &Heights,
    mips: impl Iterator<Item = ([u32; 2], &'a [u16])> + Clone,
    progress: &(dyn Fn(u64, u64) + Sync),
) -> Plane {
    let sizes: Vec<[u32; 2]> = mips.clone().map(|(size, _)| size).collect();
    let size = patches::size(sizes[0], sizes.len() > 1);
    let mut image = vec![0; size[0] as usize * size[1] as usize];
    let images = images(heights, mips, Cones::Robust, progress);
    for (mip, (texels, [width, _])) in images.iter().zip(&sizes).enumerate() {
        let [left, top] = patches::corner(sizes[0], mip as u32).map(|at| at as usize);
        for (y, row) in texels.chunks_exact(*width as usize).enumerate() {
            let words = row.iter().map(|[tip, code]| u32::from(*tip) | u32::from(*code) << 16);
            image[(top + y) * size[0] as usize + left..].iter_mut().zip(words).for_each(|(to, word)| *to = word);
        }
    }
    Plane { size, words: Words::R32(image) }
}

/// The cones of the four quadrants in one texel. A word for each way along y holds two slopes of twelve bits, toward larger x and
/// toward smaller, and above them the low or the high half of the tip's height.
pub(super) fn quadrants<'a>(
    heights: &Heights,
    mips: impl Iterator<Item = ([u32; 2], &'a [u16])> + Clone,
    progress: &(dyn Fn(u64, u64) + Sync),
) -> Plane {
    let [a, b, c, d] = [0, 1, 2, 3].map(|number| images(heights, mips.clone(), Cones::Quadrant(number), progress));
    let joined = a.iter().zip(&b).zip(c.iter().zip(&d)).map(|((a, b), (c, d))| {
        let texels = a.iter().zip(b).zip(c.iter().zip(d));
        texels.map(|((a, b), (c, d))| packed(a[0], [a[1], b[1], c[1], d[1]])).collect()
    });
    let size = mips.clone().next().map_or([1, 1], |(size, _)| size);
    Plane { size, words: Words::Rg32(joined.collect()) }
}

/// A texel of four codes, rounded up to twelve bits.
fn packed(tip: u16, codes: [u16; 4]) -> [u32; 2] {
    let [a, b, c, d] = codes.map(|code| ((u32::from(code) + 15) >> 4).min(0xfff));
    let tip = u32::from(tip);
    [a | b << 12 | (tip & 0xff) << 24, c | d << 12 | (tip >> 8) << 24]
}

/// How high the tip of a cone is: at most 65535, as the heights are.
fn tip(heights: &Heights, cones: Cones, x: u32, y: u32) -> u16 {
    match cones {
        Cones::Step | Cones::Relaxed => heights.height(x.into(), y.into()) as u16,
        Cones::Robust | Cones::Quadrant(_) => {
            let [columns, rows] = heights.cells();
            let corners = heights.corners(x.min(columns - 1).into(), y.min(rows - 1).into());
            corners.into_iter().fold(0.0, f64::max) as u16
        }
    }
}
