//! Which parts of a placed map depend on a rectangle of its texels.

use std::ops::Range;

use super::{atlas, coarse, patches};
use crate::heightfield::{Border, Heights};

/// Columns and rows.
pub type Region = [Range<u32>; 2];

/// How a map is placed: its size, its last texel, and its size filled up to powers of two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Columns and rows of the map.
    pub size: [u32; 2],
    /// The last texel on each axis, which is the first of the next tile where the map is traced tile by tile.
    pub last: [u32; 2],
    /// Columns and rows of the first mip.
    pub filled: [u32; 2],
    /// Whether it wraps as it is placed: one that is traced tile by tile ends there.
    pub wraps: bool,
    /// Mips of the heights.
    pub mips: u32,
}

impl Extent {
    /// Of a map.
    #[must_use]
    pub fn new(heights: &Heights) -> Self {
        let size = heights.size();
        let wraps = heights.border() == Border::Wrap;
        let tiled = wraps && !size.iter().all(|side| side.is_power_of_two());
        let last = size.map(|side| if tiled { side } else { side - 1 });
        let filled = last.map(|last| (last + 1).next_power_of_two());
        let wraps = wraps && !tiled;
        let mips = if wraps { filled[0].min(filled[1]).ilog2() + 1 } else { 1 };
        Self { size, last, filled, wraps, mips }
    }

    /// Of any map that tiles and whose sides are powers of two.
    #[must_use]
    pub fn tiling(map: [u32; 2]) -> Self {
        let mips = map[0].min(map[1]).max(1).ilog2() + 1;
        Self { size: map, last: map.map(|side| side.saturating_sub(1)), filled: map, wraps: true, mips }
    }

    /// Whether rays are cut at the borders of tiles.
    #[must_use]
    pub fn is_tiled(&self) -> bool {
        self.last == self.size
    }

    /// The texel of the map that a texel of the first mip is: the last again where the map has ended.
    #[must_use]
    pub fn source(&self, axis: usize, at: u32) -> u32 {
        at.min(self.last[axis]) % self.size[axis]
    }

    /// The texels of the first mip that are texels of a rectangle of the map.
    #[must_use]
    pub fn texels(&self, [columns, rows]: &Region) -> Vec<Region> {
        cross([self.texels_along(0, columns), self.texels_along(1, rows)])
    }

    /// The nodes of the finest level of a mip whose surface depends on some of its texels. Filled up a map wraps.
    #[must_use]
    pub fn cells(&self, mip: u32, texels: &[Region]) -> Vec<Region> {
        around(self.filled.map(|side| side >> mip), texels, 0)
    }

    /// Columns and rows of the image of all bounds.
    #[must_use]
    pub fn image(&self) -> [u32; 2] {
        atlas::size(self.filled)
    }

    /// Levels of the bounds of a mip: those whose sides are halves of the mip's.
    #[must_use]
    pub fn levels(&self, mip: u32) -> u32 {
        (self.filled[0].min(self.filled[1]) >> mip).ilog2() + 1
    }

    /// Where the first node of a level of a mip's bounds stands in the image.
    #[must_use]
    pub fn place(&self, mip: u32, level: u32) -> [u32; 2] {
        atlas::place(atlas::corner(self.filled, mip), level as usize)
    }

    /// Where the first patch of a mip stands in an image of patches or of cells.
    #[must_use]
    pub fn patches(&self, mip: u32) -> [u32; 2] {
        patches::corner(self.filled, mip)
    }

    /// Where the first coarse node of a mip stands in an image of cells, if the mip has a whole one.
    #[must_use]
    pub fn coarse(&self, mip: u32) -> Option<[u32; 2]> {
        coarse::corner(self.filled, mip)
    }

    fn texels_along(&self, axis: usize, range: &Range<u32>) -> Vec<Range<u32>> {
        let (last, filled) = (self.last[axis], self.filled[axis]);
        // From the last texel on it is that one again.
        let again = range.contains(&self.source(axis, last)).then_some(last..filled);
        std::iter::once(range.clone()).chain(again).collect()
    }
}

/// The texels of the next mip, or the nodes of the next level, over some.
#[must_use]
pub fn halved(regions: &[Region]) -> Vec<Region> {
    let half = |range: &Range<u32>| range.start / 2..range.end.div_ceil(2);
    distinct(regions.iter().map(|[x, y]| [half(x), half(y)]))
}

/// Texels of a map that wraps in so many columns and rows, together with those one before them and so many behind.
#[must_use]
pub fn around(size: [u32; 2], texels: &[Region], behind: u32) -> Vec<Region> {
    let along = |axis: usize, Range { start, end }: &Range<u32>| {
        let side = size[axis];
        let far = end + behind;
        let again = [(*start == 0).then(|| side - 1..side), (far > side).then(|| 0..far - side)];
        std::iter::once(start.saturating_sub(1)..far.min(side)).chain(again.into_iter().flatten()).collect::<Vec<_>>()
    };
    distinct(texels.iter().flat_map(|[x, y]| cross([along(0, x), along(1, y)])))
}

/// What of a region lies inside so many columns and rows, if anything does: what a map that ends is filled with is none of its own.
#[must_use]
pub fn inside(region: &Region, size: [u32; 2]) -> Option<Region> {
    let region = [0, 1].map(|axis| region[axis].start..region[axis].end.min(size[axis]));
    region.iter().all(|range| !range.is_empty()).then_some(region)
}

/// All pairs of columns and rows.
pub(super) fn cross([columns, rows]: [Vec<Range<u32>>; 2]) -> Vec<Region> {
    columns.iter().flat_map(|x| rows.iter().map(move |y| [x.clone(), y.clone()])).collect()
}

/// Without those that lie in others: there are few, and on coarse levels they are all alike.
fn distinct(regions: impl Iterator<Item = Region>) -> Vec<Region> {
    let holds =
        |a: &Region, b: &Region| (0..2).all(|axis| a[axis].start <= b[axis].start && b[axis].end <= a[axis].end);
    let mut kept: Vec<Region> = Vec::new();
    for region in regions {
        if !kept.iter().any(|other| holds(other, &region)) {
            kept.retain(|other| !holds(&region, other));
            kept.push(region);
        }
    }
    kept
}
