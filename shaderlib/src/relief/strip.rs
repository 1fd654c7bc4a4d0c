//! One image for the wide pyramids of all mips of a map: a strip of nodes, broken into rows.

use super::atlas;
use super::changed::Changed;
use super::dirty::{Extent, halved};
use super::mips::Mip;
use crate::heightfield::pyramid::{Bound, CHILDREN, Wide, node_over};

/// Nodes in a row of the image, and its columns.
pub(super) const COLUMNS: usize = 1024;

/// Nodes of every level of a mip with sides that are powers of two, finest first. A map of fewer cells than children is repeated.
pub(super) fn counts(size: [u32; 2]) -> Vec<usize> {
    let [width, height] = size.map(|side| side.max(CHILDREN) as usize);
    let top = width.min(height).ilog2() / 2;
    (1..=top).map(|level| width.div_ceil(1 << (2 * level)) * height.div_ceil(1 << (2 * level))).collect()
}

/// The same of all mips of a map.
fn all_counts(extent: &Extent) -> Vec<Vec<usize>> {
    (0..extent.mips).map(|mip| counts(extent.filled.map(|side| side >> mip))).collect()
}

/// Where the nodes of each mip of a map that tiles begin, in the texture of wide bounds; its sides are powers of two.
#[must_use]
pub fn wide_corners(map: [u32; 2]) -> Vec<usize> {
    corners(&all_counts(&Extent::tiling(map)))
}

/// Where the nodes of each level of each mip of a map begin, in the texture of wide bounds, the finest level first: nodes are
/// counted along the texture's rows.
#[must_use]
pub fn wide_places(extent: &Extent) -> Vec<Vec<usize>> {
    let counts = all_counts(extent);
    let places = |(first, levels): (usize, &Vec<usize>)| (1..=levels.len()).map(|level| place(first, level)).collect();
    corners(&counts).into_iter().zip(&counts).map(places).collect()
}

/// Columns and rows of the texture over all mips of a map.
pub(super) fn size(extent: &Extent) -> [u32; 2] {
    let counts = all_counts(extent);
    let ends = corners(&counts).into_iter().zip(&counts).map(|(first, levels)| first + levels[0]);
    [COLUMNS as u32, ends.max().unwrap_or(0).div_ceil(COLUMNS) as u32]
}

/// Where in the strip level k of a pyramid begins whose level 1 begins at `first`.
fn place(first: usize, level: usize) -> usize {
    first >> (4 * (level - 1))
}

/// Where level 1 of each mip begins, from the nodes of every mip's levels: the first place from which no two levels meet.
///
/// The mips follow each other, so level k of all of them is the strip of level 1 made 16 times shorter k - 1 times, and so is
/// the way to it: begun at a fifteenth of its own length, it leaves just the room for the coarser ones.
pub(super) fn corners(mips: &[Vec<usize>]) -> Vec<usize> {
    let firsts = |start: usize| {
        mips.iter().scan(start, |next, levels| {
            let first = *next;
            *next += levels[0];
            Some(first)
        })
    };
    let whole: usize = mips.iter().map(|levels| levels[0]).sum();
    (whole.div_ceil(15)..)
        .map(|start| firsts(start).collect::<Vec<_>>())
        .find(|firsts| parted(mips, firsts))
        .unwrap_or_default()
}

/// Begin and end of every level.
fn spans(mips: &[Vec<usize>], firsts: &[usize]) -> Vec<[usize; 2]> {
    let of = |(levels, first): (&Vec<usize>, &usize)| {
        let first = *first;
        let span = move |(index, nodes): (usize, &usize)| {
            let begin = place(first, index + 1);
            [begin, begin + nodes]
        };
        levels.iter().enumerate().map(span).collect::<Vec<_>>()
    };
    mips.iter().zip(firsts).flat_map(of).collect()
}

fn parted(mips: &[Vec<usize>], firsts: &[usize]) -> bool {
    let mut spans = spans(mips, firsts);
    spans.sort_unstable();
    spans.windows(2).all(|pair| pair[0][1] <= pair[1][0])
}

/// The strip, filled up to whole rows.
pub(super) fn image(mips: &[Wide], firsts: &[usize]) -> Vec<[u32; 4]> {
    let end = mips.iter().zip(firsts).map(|(mip, first)| first + mip.levels[0].values.len()).max().unwrap_or(0);
    let mut image = vec![[0; 4]; end.next_multiple_of(COLUMNS)];
    for (mip, first) in mips.iter().zip(firsts) {
        for (index, level) in mip.levels.iter().enumerate() {
            image[place(*first, index + 1)..][..level.values.len()].copy_from_slice(&level.values);
        }
    }
    image
}

/// Packs the nodes over changed texels again.
pub(super) fn update(image: &mut [[u32; 4]], change: &Changed<'_>) {
    for ((index, mip), places) in (0..).zip(change.after).zip(wide_places(change.extent)) {
        let finer = repeated(mip).as_ref().unwrap_or(mip).quadtree(Bound::CellMax);
        // Of a side that is repeated all cells are under one node.
        let mut nodes = change.extent.cells(index, &change.texels[index as usize]);
        for (level, first) in places.into_iter().enumerate() {
            nodes = halved(&halved(&nodes));
            let columns = finer[0].size[0].div_ceil(CHILDREN << (2 * level));
            atlas::each(&nodes, |x, y| image[first + (y * columns + x) as usize] = node_over(&finer, level, [x, y]));
        }
    }
}

/// A map of fewer cells than a node has children, repeated; `None` for others.
pub(super) fn repeated(mip: &Mip) -> Option<Mip> {
    let size = mip.size.map(|side| side.max(CHILDREN));
    let columns = |y: u32| (0..size[0]).map(move |x| y % mip.size[1] * mip.size[0] + x % mip.size[0]);
    let texels = || (0..size[1]).flat_map(columns).map(|index| mip.texels[index as usize]).collect();
    (size != mip.size).then(|| Mip { size, texels: texels() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_levels_share_a_texel() {
        let sizes = (0..14).flat_map(|x| (0..14).map(move |y| [1_u32 << x, 1 << y]));
        for size in sizes {
            let mips = all_counts(&Extent::tiling(size));
            let mut spans = spans(&mips, &corners(&mips));
            assert_eq!(spans.len(), mips.iter().map(Vec::len).sum::<usize>());
            spans.sort_unstable();
            for pair in spans.windows(2) {
                assert!(pair[0][1] <= pair[1][0], "{size:?}: {pair:?}");
            }
        }
    }

    #[test]
    fn a_map_takes_1_1_bytes_a_texel_and_1_5_with_its_mips() {
        for side in [1024, 2048, 4096, 8192] {
            let bytes = |mips: &[Vec<usize>]| {
                let end = spans(mips, &corners(mips)).iter().map(|span| span[1]).max().expect("there are levels");
                (end.next_multiple_of(COLUMNS) * 16) as f64 / (side * side) as f64
            };
            let mips = all_counts(&Extent::tiling([side; 2]));
            assert!(bytes(&mips[..1]) <= 1.1, "{side}: {}", bytes(&mips[..1]));
            assert!(bytes(&mips) <= 1.5, "{side}: {}", bytes(&mips));
        }
    }
}
