//! The wide pyramid: one 128-bit texel holds the bounds of sixteen children.

use std::ops::Range;

use rayon::prelude::*;

use super::level::{Level, Region};
use super::{Bound, Levels, Pyramid};
use crate::heightfield::heights::Heights;

/// Children of a node along each axis.
pub const CHILDREN: u32 = 4;
/// Bits of a child's own, and of a node's base.
const OWN: u32 = 7;
const BASE: u32 = 12;

/// A pyramid of four by four children to a node, a node four 32-bit words.
///
/// The low seven bits of byte 4 j + i of a node (of its sixteen, the lowest bits first) are for child (i, j), the high bits for
/// the node, bit 4 j + i of sixteen: twelve are its base, four its shift. The surface over the child is at most
/// `(base << unit) + ((bits + 1) << shift)` steps high. Children beyond the map have those of its last ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Wide {
    /// Steps of the map to a step of a base, as a power of two: the least with which the highest fits that there could be.
    pub unit: u32,
    /// The nodes whose children are the cells come first, the one over the whole map last.
    pub levels: Vec<Level<[u32; 4]>>,
}

impl Wide {
    /// Packs the maxima of the map's cells. Heights of a map of floats have no steps: give their 16-bit form.
    ///
    /// # Errors
    /// For a map of floats.
    pub fn new(heights: &Heights) -> Result<Self, FloatHeights> {
        Self::over(&Pyramid::new(heights, Bound::CellMax))
    }

    /// Packs the levels of a pyramid of [`Bound::CellMax`].
    ///
    /// # Errors
    /// For one over a map of floats.
    ///
    /// # Panics
    /// If it bounds something else.
    pub fn over(cells: &Pyramid) -> Result<Self, FloatHeights> {
        assert_eq!(cells.bound, Bound::CellMax, "wide nodes hold the largest heights of cells");
        match cells.levels() {
            Levels::U8(levels) => Ok(Self::pack(levels, 0)),
            Levels::U16(levels) => Ok(Self::pack(levels, u16::BITS - BASE)),
            Levels::F32(_) => Err(FloatHeights),
        }
    }

    fn pack<T: Copy + Into<u32> + Sync>(finer: &[Level<T>], unit: u32) -> Self {
        let mut levels = Vec::new();
        let mut size = finer[0].size;
        while levels.is_empty() || size != [1, 1] {
            size = size.map(|side| side.div_ceil(CHILDREN));
            let mut level = Level::blank(size);
            let whole = level.whole();
            nodes(children(finer, levels.len()), &mut level, &whole, unit);
            levels.push(level);
        }
        Self { unit, levels }
    }

    /// Packs the nodes over a rectangle of changed texels again: columns and rows inside the map, whose pyramid has been brought up
    /// to date ([`Pyramid::update`]).
    ///
    /// # Panics
    /// If the map has another size or kind of texels than that which this was packed from.
    pub fn update(&mut self, cells: &Pyramid, heights: &Heights, texels: &[Range<u32>; 2]) {
        if texels.iter().any(Range::is_empty) {
            return;
        }
        for region in Bound::CellMax.touched(heights, texels.clone()) {
            match (cells.levels(), self.unit) {
                (Levels::U8(levels), 0) => self.repack(levels, region),
                (Levels::U16(levels), 1..) => self.repack(levels, region),
                _ => panic!("a wide pyramid over another kind of texels"),
            }
        }
    }

    fn repack<T: Copy + Into<u32> + Sync>(&mut self, finer: &[Level<T>], mut region: Region) {
        for (index, level) in self.levels.iter_mut().enumerate() {
            region = region.map(|range| range.start / CHILDREN..range.end.div_ceil(CHILDREN));
            nodes(children(finer, index), level, &region, self.unit);
        }
    }

    /// What the pyramid says of a child: the level of its node, from 1, and its column and row among all children there.
    ///
    /// # Panics
    /// If there is no such child.
    #[must_use]
    pub fn bound(&self, level: usize, x: u32, y: u32) -> u32 {
        let node = self.levels[level - 1].at(x / CHILDREN, y / CHILDREN);
        let high = |index: u32| node[(index / CHILDREN) as usize] >> (8 * (index % CHILDREN) + OWN) & 1;
        let header = (0..CHILDREN * CHILDREN).map(|index| high(index) << index).sum::<u32>();
        let own = node[(y % CHILDREN) as usize] >> (8 * (x % CHILDREN)) & ((1 << OWN) - 1);
        ((header & ((1 << BASE) - 1)) << self.unit) + ((own + 1) << (header >> BASE))
    }

    /// Bytes of all nodes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.levels.iter().map(|level| size_of_val(&level.values[..])).sum()
    }
}

/// A map of floats where steps are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FloatHeights;

impl std::fmt::Display for FloatHeights {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        to.write_str("a wide pyramid holds whole steps: quantise the map of floats first")
    }
}

impl std::error::Error for FloatHeights {}

/// Heights over a node's children, row by row; beyond the map those of its last ones.
type Children = [[u32; CHILDREN as usize]; CHILDREN as usize];

/// What the nodes of a level are over: a level of four by four children is every second one of two by two; the coarsest may be
/// missing.
fn children<T>(finer: &[Level<T>], level: usize) -> &Level<T> {
    &finer[(2 * level).min(finer.len() - 1)]
}

/// Packs the nodes of a region.
fn nodes<T: Copy + Into<u32> + Sync>(children: &Level<T>, into: &mut Level<[u32; 4]>, region: &Region, unit: u32) {
    let columns = region[0].start as usize..region[0].end as usize;
    let whole_rows = into.values.par_chunks_mut(into.size[0] as usize).enumerate();
    whole_rows.skip(region[1].start as usize).take(region[1].len()).for_each(|(y, nodes)| {
        for (x, into) in columns.clone().zip(&mut nodes[columns.clone()]) {
            *into = node(children, [x as u32, y as u32], unit);
        }
    });
}

/// Packs a node over its level of children.
fn node<T: Copy + Into<u32>>(children: &Level<T>, [x, y]: [u32; 2], unit: u32) -> [u32; 4] {
    let last = children.size.map(|side| side - 1);
    let first = (CHILDREN * x) as usize;
    let near = [0, 1, 2, 3].map(|column| (first + column).min(last[0] as usize));
    let rows = [0, 1, 2, 3].map(|row| children.row((CHILDREN * y + row).min(last[1])));
    packed(
        rows.map(|row| match row.get(first..).and_then(<[T]>::first_chunk) {
            Some(whole) => whole.map(Into::into),
            None => near.map(|column| row[column].into()),
        }),
        unit,
    )
}

/// The node of a level, from 0, over a quadtree of 16-bit heights.
pub(crate) fn node_over(finer: &[Level<u16>], level: usize, at: [u32; 2]) -> [u32; 4] {
    node(children(finer, level), at, u16::BITS - BASE)
}

/// A node: bounds over its base, rounded down from the largest height less one, so that one more is not below it.
fn packed(children: Children, unit: u32) -> [u32; 4] {
    let heights = children.map(|row| row.map(|height| height.saturating_sub(1)));
    let low = heights.map(|row| row.into_iter().fold(u32::MAX, u32::min)).into_iter().fold(u32::MAX, u32::min);
    let high = heights.map(|row| row.into_iter().fold(0, u32::max)).into_iter().fold(0, u32::max);
    let base = low >> unit;
    let shift = bits(high - (base << unit)).saturating_sub(OWN);
    let header = base | shift << BASE;
    let own = heights.map(|row| row.map(|height| (height - (base << unit)) >> shift));
    let word = |row: usize, [a, b, c, d]: [u32; 4]| a | b << 8 | c << 16 | d << 24 | spread(header >> (4 * row));
    [word(0, own[0]), word(1, own[1]), word(2, own[2]), word(3, own[3])]
}

/// The low four bits as the high bits of four bytes.
fn spread(bits: u32) -> u32 {
    // A copy for each byte, seven places on: in it the bit that is wanted is the lowest.
    (((bits & 15) * 0x0020_4081) & 0x0101_0101) << OWN
}

/// How many bits a number has.
fn bits(number: u32) -> u32 {
    u32::BITS - number.leading_zeros()
}
