//! One image for the quadtrees of all mips of a map.

use super::dirty::{Region, halved};
use super::mips::Mip;
use crate::heightfield::pyramid::{Bound, Level};

/// The texel of a level's first node: level 0 of a mip of w × h cells stands at `corner`, and level k at `corner >> k`.
pub(super) fn place(corner: [u32; 2], level: usize) -> [u32; 2] {
    corner.map(|at| at >> level)
}

/// Where mip `mip` stands, in its own cells: strips of levels of equal size side by side. No two levels share a texel, since
/// a strip of sides n begins at row n, mip m at column m n, and there are fewer than w / n mips that have such a level.
pub(super) fn corner([width, height]: [u32; 2], mip: u32) -> [u32; 2] {
    [mip * (width >> mip), height >> mip]
}

/// Columns and rows of the image over a map of so many cells.
pub(super) fn size([width, height]: [u32; 2]) -> [u32; 2] {
    [width, 2 * height]
}

/// Writes the levels of a mip's quadtree. Those whose sides are no longer both halved stay away.
pub(super) fn write(image: &mut [u16], width: u32, corner: [u32; 2], levels: &[Level<u16>]) {
    for (index, level) in levels.iter().enumerate() {
        let [left, top] = place(corner, index);
        let rows = image.chunks_exact_mut(width as usize).skip(top as usize);
        let [columns, _] = level.size;
        for (row, values) in rows.zip(level.values.chunks_exact(columns as usize)) {
            row[left as usize..][..columns as usize].copy_from_slice(values);
        }
    }
}

/// Brings the levels over some nodes of a mip's finest one up to date.
pub(super) fn update<T: Copy + Ord + From<u16>>(
    image: &mut [T],
    size: [u32; 2],
    (index, mip): (u32, &Mip),
    bound: Bound,
    nodes: Vec<Region>,
) {
    let corner = corner(size, index);
    let [width, height] = mip.size;
    let texel = |x: u32, y: u32| mip.texels[(y % height * width + x % width) as usize];
    each(&nodes, |x, y| {
        let highest = match bound {
            Bound::TexelMax => texel(x, y),
            _ => texel(x, y).max(texel(x + 1, y)).max(texel(x, y + 1)).max(texel(x + 1, y + 1)),
        };
        image[((corner[1] + y) * size[0] + corner[0] + x) as usize] = highest.into();
    });
    let mut nodes = nodes;
    for level in 1..=width.min(height).ilog2() as usize {
        nodes = halved(&nodes);
        let [finer, coarser] = [level - 1, level].map(|level| place(corner, level));
        each(&nodes, |x, y| {
            let child = |i: u32, j: u32| image[((finer[1] + 2 * y + j) * size[0] + finer[0] + 2 * x + i) as usize];
            let highest = child(0, 0).max(child(1, 0)).max(child(0, 1)).max(child(1, 1));
            image[((coarser[1] + y) * size[0] + coarser[0] + x) as usize] = highest;
        });
    }
}

/// Visits each node of some regions.
pub(super) fn each(regions: &[Region], mut visit: impl FnMut(u32, u32)) {
    for [columns, rows] in regions {
        for y in rows.clone() {
            columns.clone().for_each(|x| visit(x, y));
        }
    }
}
