//! Cones and their tips as one image.

pub(super) mod update;

use rayon::prelude::*;

use super::dirty::Extent;
use super::mips::Mip;
use super::plane::{Plane, Words};
use super::{coarse, patches};
use crate::heightfield::cones::{self, ConeMap, Cones, standing};
use crate::heightfield::{Border, Heights, Texels};

/// Told, from any thread, how much of some cones is done and how much there is of them.
type Progress<'a> = &'a (dyn Fn(u64, u64) + Sync);

/// The cones of a map and of its coarser mips. A texel holds the height of a cone's tip and the code of [`ConeMap`].
pub(super) fn plane(heights: &Heights, mips: &[Mip], cones: Cones, progress: Progress<'_>) -> Plane {
    let images = mips.iter().map(|mip| image(&own(heights, mip), mip.size, cones, progress));
    Plane { size: mips[0].size, words: Words::Rg16(images.collect()) }
}

/// The texels of a mip that cones stand on. A map that wraps is filled already; one that does not has one mip, and of that those
/// which are the map's.
fn own(heights: &Heights, Mip { size: filled, texels }: &Mip) -> Heights {
    let border = heights.border();
    let size = if border == Border::Wrap { *filled } else { heights.size() };
    let rows = texels.chunks_exact(filled[0] as usize).take(size[1] as usize);
    let own = rows.flat_map(|row| &row[..size[0] as usize]).copied().collect();
    Heights::new(size, border, Texels::U16(own)).expect("no larger than the map, and whole rows")
}

fn image(heights: &Heights, [width, height]: [u32; 2], cones: Cones, progress: Progress<'_>) -> Vec<[u16; 2]> {
    let map = ConeMap::new(heights, cones, progress);
    let [columns, rows] = map.size;
    let mut image = vec![[0; 2]; width as usize * height as usize];
    image.par_chunks_mut(width as usize).enumerate().for_each(|(y, row)| {
        let y = (y as u32).min(rows - 1);
        for (x, texel) in row.iter_mut().enumerate() {
            let x = (x as u32).min(columns - 1);
            *texel = [tip(heights, cones, [x, y]), map.codes[(y * columns + x) as usize]];
        }
    });
    image
}

/// The cones of the four quadrants in two words of a texel, and the cell's patch in the other two: those of all mips in one image,
/// where patches stand, and cones over coarse nodes.
pub(super) fn cells(heights: &Heights, mips: &[Mip], progress: Progress<'_>) -> Plane {
    let map = mips[0].size;
    let size = coarse::size(map, mips.len() > 1);
    let mut image = vec![[0; 4]; size[0] as usize * size[1] as usize];
    let mut write = |corner: [u32; 2], width: u32, cones: &[[u32; 2]]| {
        let [left, top] = corner.map(|at| at as usize);
        for (y, row) in cones.chunks_exact(width as usize).enumerate() {
            let cells = &mut image[(top + y) * size[0] as usize + left..];
            cells.iter_mut().zip(row).for_each(|(cell, cones)| cell[..2].copy_from_slice(cones));
        }
    };
    for (index, mip) in (0..).zip(mips) {
        write(patches::corner(map, index), mip.size[0], &toward_all(&own(heights, mip), mip.size, progress));
        if let Some(corner) = coarse::corner(map, index) {
            let nodes = coarse::nodes(mip.size);
            write(corner, nodes[0], &toward_all(&coarse::heights(mip, heights.border()), nodes, progress));
        }
    }
    let wraps = Extent::new(heights).wraps;
    for (index, mip) in (0..).zip(mips) {
        let patch = |cell: &mut [u32; 4], patch: [u32; 2]| cell[2..].copy_from_slice(&patch);
        let all = mip.size.map(|side| 0..side);
        patches::write(&mut image, size[0], patches::corner(map, index), (mip, wraps), &all, patch);
    }
    Plane { size, words: Words::Rgba32(image) }
}

/// The cones of the four quadrants in one texel.
pub(super) fn quadrants(heights: &Heights, mips: &[Mip], progress: Progress<'_>) -> Plane {
    let images = mips.iter().map(|mip| toward_all(&own(heights, mip), mip.size, progress));
    Plane { size: mips[0].size, words: Words::Rg32(images.collect()) }
}

/// A word for each way along y holds two slopes of twelve bits, toward larger x and toward smaller, and above them the low or the
/// high half of the tip's height.
fn toward_all(heights: &Heights, size: [u32; 2], progress: Progress<'_>) -> Vec<[u32; 2]> {
    let [a, b, c, d] = [0, 1, 2, 3].map(|number| image(heights, size, Cones::Quadrant(number), progress));
    let texels = a.iter().zip(b).zip(c.iter().zip(d));
    texels.map(|((a, b), (c, d))| packed(a[0], [a[1], b[1], c[1], d[1]])).collect()
}

/// A texel of four codes, rounded up to twelve bits.
fn packed(tip: u16, codes: [u16; 4]) -> [u32; 2] {
    let [a, b, c, d] = codes.map(twelve);
    let tip = u32::from(tip);
    [a | b << 12 | (tip & 0xff) << 24, c | d << 12 | (tip >> 8) << 24]
}

/// A code rounded up to twelve bits.
fn twelve(code: u16) -> u32 {
    ((u32::from(code) + 15) >> 4).min(0xfff)
}

/// How high the tip of the cone at a texel is: at most 65535, as the heights are. Behind the last cone it is that again.
fn tip(heights: &Heights, cones: Cones, texel: [u32; 2]) -> u16 {
    let standing = standing(heights, cones);
    cones::tip(heights, cones, [0, 1].map(|axis| (texel[axis] as usize).min(standing[axis] - 1))) as u16
}
