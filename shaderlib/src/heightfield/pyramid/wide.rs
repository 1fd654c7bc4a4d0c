//! The wide pyramid: one 128-bit texel holds the bounds of sixteen children.

use rayon::prelude::*;

use super::level::Level;
use super::{Bound, Levels, Pyramid};
use crate::heightfield::heights::Heights;

/// Children of a node along each axis.
pub const CHILDREN: u32 = 4;

/// A pyramid of four by four children to a node, a node four 32-bit words.
///
/// Byte 4 j + i of a node (of its sixteen, the lowest bits first) bounds child (i, j): the surface there is at most
/// `(byte + 1) << shift` steps high. Children beyond the map have 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Wide {
    /// Steps of the map to a step of a bound, as a power of two: the least with which the highest fits.
    pub shift: u32,
    /// The nodes whose children are the cells come first, the one over the whole map last.
    pub levels: Vec<Level<[u32; 4]>>,
}

impl Wide {
    /// Packs the maxima of the map's cells. Heights of a map of floats have no steps: give their 16-bit form.
    ///
    /// # Errors
    /// For a map of floats.
    pub fn new(heights: &Heights) -> Result<Self, FloatHeights> {
        match Pyramid::new(heights, Bound::CellMax).levels() {
            Levels::U8(levels) => Ok(Self::pack(levels)),
            Levels::U16(levels) => Ok(Self::pack(levels)),
            Levels::F32(_) => Err(FloatHeights),
        }
    }

    fn pack<T: Copy + Into<u32> + Sync>(finer: &[Level<T>]) -> Self {
        let highest: u32 = finer[finer.len() - 1].at(0, 0).into();
        let shift = (u32::BITS - highest.leading_zeros()).saturating_sub(u8::BITS);
        let mut levels = Vec::new();
        let mut size = finer[0].size;
        while levels.is_empty() || size != [1, 1] {
            size = size.map(|side| side.div_ceil(CHILDREN));
            // A level of four by four children is every second one of two by two; the coarsest may be missing.
            levels.push(nodes(&finer[(2 * levels.len()).min(finer.len() - 1)], size, shift));
        }
        Self { shift, levels }
    }

    /// What the pyramid says of a child: the level of its node, from 1, and its column and row among all children there.
    ///
    /// # Panics
    /// If there is no such child.
    #[must_use]
    pub fn bound(&self, level: usize, x: u32, y: u32) -> u32 {
        let node = self.levels[level - 1].at(x / CHILDREN, y / CHILDREN);
        let byte = node[(y % CHILDREN) as usize] >> (8 * (x % CHILDREN)) & 0xff;
        (byte + 1) << self.shift
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

fn nodes<T: Copy + Into<u32> + Sync>(children: &Level<T>, size: [u32; 2], shift: u32) -> Level<[u32; 4]> {
    let mut level = Level::blank(size);
    level.values.par_chunks_mut(size[0] as usize).enumerate().for_each(|(y, nodes)| {
        (0..CHILDREN).for_each(|j| word(children, CHILDREN * y as u32 + j, shift, nodes, j as usize));
    });
    level
}

/// The bounds of a row of children, word `index` of each node over it: a byte is the largest height less one, rounded down,
/// so that `(byte + 1) << shift` is not below it. Where there are no children, 0 stays.
fn word<T: Copy + Into<u32>>(children: &Level<T>, row: u32, shift: u32, nodes: &mut [[u32; 4]], index: usize) {
    if row >= children.size[1] {
        return;
    }
    let byte = |highest: T| highest.into().saturating_sub(1) >> shift;
    let (whole, rest) = children.row(row).as_chunks::<{ CHILDREN as usize }>();
    for (node, [a, b, c, d]) in nodes.iter_mut().zip(whole) {
        node[index] = byte(*a) | byte(*b) << 8 | byte(*c) << 16 | byte(*d) << 24;
    }
    if let Some(node) = nodes.get_mut(whole.len()) {
        node[index] = rest.iter().rev().fold(0, |word, highest| word << 8 | byte(*highest));
    }
}
