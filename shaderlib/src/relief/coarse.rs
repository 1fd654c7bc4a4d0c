//! Cones over nodes of a map: few enough for caches to hold, for as long as a ray is far above the ground.
//!
//! The nodes are those of a level of the quadtree, and the cones are robust ones, over the coarse map whose texels are the corners
//! of nodes, each as high as the highest node that meets there. Between four corners that map lies nowhere below the node, so
//! what is free above it is free of the surface.

use std::ops::Range;

use super::dirty::{Region, cross, halved};
use super::mips::Mip;
use super::patches;
use crate::heightfield::pyramid::Bound;
use crate::heightfield::{Border, Heights, Texels};

/// log2 of the cells along a node.
pub const COARSE: u32 = 3;

/// Texels along the shorter side of a mip from which on searches begin over nodes: below it caches held enough of
/// the cells' cones, and a search that begins over cells took a tenth less time on smooth ground (docs/relief/notebook.md; when a cone was
/// a word).
pub const LARGE: u32 = 4096;

/// Columns and rows of nodes over a mip.
pub(super) fn nodes(mip: [u32; 2]) -> [u32; 2] {
    mip.map(|side| side >> COARSE)
}

/// Where the first node over a mip of a map stands in the image of all cells, if the mip has a whole one: under the mip that is as
/// large.
pub(super) fn corner(map: [u32; 2], mip: u32) -> Option<[u32; 2]> {
    let [left, top] = patches::corner(map, mip + COARSE);
    let rows = map[1].checked_shr(mip + COARSE)?;
    (map[0].min(map[1]) >> mip >= 1 << COARSE).then_some([left, top + rows])
}

/// The same where searches begin there, as they do over a mip whose sides have so many texels; −1 where they begin over cells.
pub(super) fn begin(map: [u32; 2], mip: u32, from: u32) -> [i32; 2] {
    let corner = corner(map, mip).filter(|_| map[0].min(map[1]) >> mip >= from);
    corner.map_or([-1; 2], |corner| corner.map(|at| at as i32))
}

/// Columns and rows of the image of the cells over a map: nodes stand where no mip's cells do.
pub(super) fn size(map: [u32; 2], has_mips: bool) -> [u32; 2] {
    patches::size(map, has_mips || corner(map, 0).is_some())
}

/// The coarse map over a mip of a map with such a border.
pub(super) fn heights(mip: &Mip, border: Border) -> Heights {
    let levels = mip.quadtree(Bound::CellMax);
    let level = &levels[COARSE as usize];
    let [columns, rows] = level.size;
    let around = |at: u32, count: u32| match border {
        Border::Wrap => [(at + count - 1) % count, at],
        Border::Clamp => [at.saturating_sub(1), at.min(count - 1)],
    };
    let size = if border == Border::Wrap { level.size } else { level.size.map(|side| side + 1) };
    let texels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y])).map(|[x, y]| {
        let [[left, right], [above, below]] = [around(x, columns), around(y, rows)];
        level.at(left, above).max(level.at(right, above)).max(level.at(left, below)).max(level.at(right, below))
    });
    Heights::new(size, border, Texels::U16(texels.collect())).expect("fewer texels than the map")
}

/// The texels of the coarse map, of which it has so many columns and rows, that are corners of the nodes over some cells.
#[must_use]
pub fn texels(cells: &[Region], size: [u32; 2], border: Border) -> Vec<Region> {
    let nodes = (0..COARSE).fold(cells.to_vec(), |cells, _| halved(&cells));
    let along = |axis: usize, nodes: &Range<u32>| {
        let is_seam = border == Border::Wrap && nodes.end == size[axis];
        let first = is_seam.then_some(0..1);
        std::iter::once(nodes.start..(nodes.end + 1).min(size[axis])).chain(first).collect::<Vec<_>>()
    };
    nodes.iter().flat_map(|[columns, rows]| cross([along(0, columns), along(1, rows)])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::heightfield::adversary::{Depth, LANDS, map};
    use crate::heightfield::cones::SLOPE;
    use crate::relief::{Bounds, Extent, MapTexture, Placed};

    /// How far a texel is from what lies between two others, one way, the map repeated where it wraps; nothing where it lies the
    /// other way.
    fn away(at: u32, [first, last]: [u32; 2], side: u32, border: Border, is_backward: bool) -> Option<u32> {
        let (at, first, last, side) = (i64::from(at), i64::from(first), i64::from(last), i64::from(side));
        let turns = if border == Border::Wrap { -1..=1 } else { 0..=0 };
        let ahead = turns.map(|turn| if is_backward { last - at - turn * side } else { at + turn * side - first });
        ahead.filter(|ahead| *ahead >= 0).map(|ahead| (ahead - (last - first)).max(0) as u32).min()
    }

    fn texels([width, height]: [u32; 2]) -> impl Iterator<Item = [u32; 2]> {
        (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]))
    }

    /// The tip of the cone toward a quadrant, and how steep it is.
    fn toward([north, south, ..]: [u32; 4], quadrant: u32) -> (f64, f64) {
        let word = if quadrant < 2 { north } else { south };
        let code = word >> (12 * (quadrant & 1)) & 0xfff;
        (f64::from(north >> 24 | south >> 24 << 8), f64::from(SLOPE.value((code << 4) as u16)))
    }

    /// Nothing stands out of a cone, from wherever over its node it is looked at.
    #[test]
    fn cones_over_nodes_are_free_of_the_map() {
        for (size, border) in [([32, 16], Border::Wrap), ([64, 64], Border::Wrap), ([29, 41], Border::Clamp)] {
            for (index, land) in LANDS.into_iter().enumerate() {
                let heights = map(land, size, border, Depth::Sixteen, index as u64).unwrap();
                let image = Placed::new(&heights, Bounds::Cells, 1).unwrap().bounds;
                let filled = size.map(u32::next_power_of_two);
                let corner = corner(filled, 0).unwrap();
                // Cells end one before the last texel of a map that ends.
                let nodes = border.cells(size).map(|cells| cells.div_ceil(1 << COARSE));
                for node in (0..nodes[1]).flat_map(|y| (0..nodes[0]).map(move |x| [x, y])) {
                    let words = image.texel(0, [0, 1].map(|axis| corner[axis] + node[axis])).unwrap();
                    let across = [0, 1].map(|axis| [node[axis] << COARSE, (node[axis] + 1) << COARSE]);
                    for (quadrant, [x, y]) in (0..4).flat_map(|quadrant| texels(size).map(move |at| (quadrant, at))) {
                        let along =
                            |axis: usize, at| away(at, across[axis], size[axis], border, quadrant >> axis & 1 > 0);
                        let (Some(east), Some(north)) = (along(0, x), along(1, y)) else { continue };
                        let (tip, slope) = toward(words, quadrant);
                        let free = tip + slope * f64::from(east.max(north)) / f64::from(1 << COARSE);
                        let height = heights.height(x.into(), y.into());
                        assert!(height <= free, "{land:?} {size:?}: {node:?} {x} {y}: {height} over {free}");
                    }
                }
            }
        }
    }

    /// Of every texel that changes, all texels of the coarse map that change with it are told.
    #[test]
    fn what_depends_on_a_texel_is_told() {
        for (border, at) in [Border::Wrap, Border::Clamp].into_iter().flat_map(|border| {
            texels([32, 16]).filter(|[x, y]| x % 7 < 2 && y % 7 < 2 || x % 31 == 0).map(move |at| (border, at))
        }) {
            let mip = |height| {
                let mut texels = vec![0; 32 * 16];
                texels[(at[1] * 32 + at[0]) as usize] = height;
                Mip { size: [32, 16], texels }
            };
            let flat = Heights::new([32, 16], border, Texels::U16(vec![0; 32 * 16])).unwrap();
            let cells = Extent::new(&flat).cells(0, &[at.map(|at| at..at + 1)]);
            let [before, after] = [0, 9].map(|height| heights(&mip(height), border));
            let told = super::texels(&cells, after.size(), border);
            let is_told = |at: [u32; 2]| told.iter().any(|texels| (0..2).all(|axis| texels[axis].contains(&at[axis])));
            for [x, y] in texels(after.size()) {
                let is_other = before.height(x.into(), y.into()) != after.height(x.into(), y.into());
                assert!(!is_other || is_told([x, y]), "{border:?} {at:?}: {x} {y} of {told:?}");
            }
            assert!(told.iter().flatten().all(|range| range.len() <= 3), "{border:?} {at:?}: {told:?}");
        }
    }

    #[test]
    fn nodes_lie_apart_from_cells() {
        for map in [[8u32, 8], [16, 8], [64, 256], [512, 512]] {
            let mips = map[0].min(map[1]).ilog2() + 1;
            let size = size(map, true);
            let mut taken = vec![false; size[0] as usize * size[1] as usize];
            let cells = (0..mips).map(|mip| (patches::corner(map, mip), map.map(|side| side >> mip)));
            let over = (0..mips).filter_map(|mip| Some((corner(map, mip)?, nodes(map.map(|side| side >> mip)))));
            for ([left, top], [width, height]) in cells.chain(over) {
                for [x, y] in (top..top + height).flat_map(|y| (left..left + width).map(move |x| [x, y])) {
                    let texel = &mut taken[(y * size[0] + x) as usize];
                    assert!(!std::mem::replace(texel, true), "{map:?}: {x} {y} is taken");
                }
            }
        }
        assert_eq!(begin([LARGE; 2], 0, LARGE), [(LARGE - LARGE / 4) as i32, (LARGE + LARGE / 8) as i32]);
        assert_eq!([begin([LARGE; 2], 1, LARGE), begin([4, 4], 0, 0)], [[-1; 2]; 2]);
        assert_eq!(MapTexture::Bounds(Bounds::Cells).size([4, 4]), [4, 6]);
    }
}
