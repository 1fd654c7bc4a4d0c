//! The wide pyramid: one 128-bit texel holds the bounds of sixteen children.

use rayon::prelude::*;

use super::level::Level;
use super::{Bound, Levels, Pyramid};
use crate::heightfield::heights::Heights;

/// Children of a node along each axis.
pub const CHILDREN: u32 = 4;

/// A pyramid of four by four children to a node, all levels in one image of four 32-bit words to a texel.
///
/// Byte 4 j + i of a node (of its sixteen, the lowest bits first) bounds child (i, j): the surface there is at most
/// `(byte + 1) << shift` steps high. Children beyond the map have 0. Level 1, whose children are the cells, stands at the
/// left; the others stand in the column to the right of it, the finer ones above.
#[derive(Clone, Debug, PartialEq)]
pub struct Wide {
    /// Steps of the map to a step of a bound, as a power of two: 0 for 8-bit maps, 8 for 16-bit ones.
    pub shift: u32,
    /// Columns and rows of the image.
    pub size: [u32; 2],
    /// Texels, row by row.
    pub texels: Vec<[u32; 4]>,
    /// Columns and rows of each level and where it stands; level 1 comes first.
    pub levels: Vec<Place>,
}

/// A level in the image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Columns and rows of nodes.
    pub size: [u32; 2],
    /// The texel of its first node.
    pub at: [u32; 2],
}

impl Wide {
    /// Packs the maxima of the map's cells. Heights of a map of floats have no steps: give their 16-bit form.
    ///
    /// # Errors
    /// For a map of floats.
    pub fn new(heights: &Heights) -> Result<Self, FloatHeights> {
        match Pyramid::new(heights, Bound::CellMax).levels() {
            Levels::U8(levels) => Ok(Self::pack(levels, 0)),
            Levels::U16(levels) => Ok(Self::pack(levels, 8)),
            Levels::F32(_) => Err(FloatHeights),
        }
    }

    fn pack<T: Copy + Into<u32> + Sync>(levels: &[Level<T>], shift: u32) -> Self {
        let places = places(levels[0].size);
        let size = places.iter().fold([0, 0], |size, place| [0, 1].map(|i| size[i].max(place.at[i] + place.size[i])));
        let mut texels = vec![[0; 4]; size[0] as usize * size[1] as usize];
        for (index, place) in places.iter().enumerate() {
            // A level of four by four children is every second one of two by two; the coarsest may be missing.
            let children = &levels[(2 * index).min(levels.len() - 1)];
            let rows = texels.par_chunks_mut(size[0] as usize).skip(place.at[1] as usize).take(place.size[1] as usize);
            rows.enumerate().for_each(|(y, row)| {
                let nodes = &mut row[place.at[0] as usize..][..place.size[0] as usize];
                (0..CHILDREN).for_each(|j| word(children, CHILDREN * y as u32 + j, shift, nodes, j as usize));
            });
        }
        Self { shift, size, texels, levels: places }
    }

    /// What the pyramid says of a child: the level of its node, from 1, and its column and row among all children there.
    ///
    /// # Panics
    /// If there is no such child.
    #[must_use]
    pub fn bound(&self, level: usize, x: u32, y: u32) -> u32 {
        let place = self.levels[level - 1];
        let [column, row] = [place.at[0] + x / CHILDREN, place.at[1] + y / CHILDREN];
        let texel = self.texels[(row * self.size[0] + column) as usize];
        let byte = texel[(y % CHILDREN) as usize] >> (8 * (x % CHILDREN)) & 0xff;
        (byte + 1) << self.shift
    }

    /// Bytes of the image.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(&self.texels[..])
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

fn places(cells: [u32; 2]) -> Vec<Place> {
    let mut size = cells.map(|side| side.div_ceil(CHILDREN));
    let (right, mut top) = (size[0], 0);
    let mut places = vec![Place { size, at: [0, 0] }];
    while size[0] > 1 || size[1] > 1 {
        size = size.map(|side| side.div_ceil(CHILDREN));
        places.push(Place { size, at: [right, top] });
        top += size[1];
    }
    places
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
