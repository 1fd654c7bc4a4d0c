//! One image for the quadtrees of all mips of a map.

use crate::heightfield::pyramid::Level;

/// The texel of a level's first node: level 0 of a mip of w × h cells stands at `corner`, and level k at `corner >> k`.
fn place(corner: [u32; 2], level: usize) -> [u32; 2] {
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
