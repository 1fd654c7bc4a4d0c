//! Pyramids: for every node of a quadtree over the map, a bound of the surface inside it.
//!
//! Level 0 is the finest; a node of level k + 1 is two by two nodes of level k, or what there is of them at the border.

mod bands;
mod bound;
mod level;
mod reduce;
mod wide;

use std::ops::Range;

use self::reduce::{Extreme, Height, Max, Min, cell_row, cells, nodes};
use super::heights::{Heights, Texels};

pub use self::bound::Bound;
pub use self::level::Level;
pub(crate) use self::wide::node_over;
pub use self::wide::{CHILDREN, Wide};

/// All levels, the finest first; the coarsest is one node.
#[derive(Clone, Debug, PartialEq)]
pub enum Levels {
    /// Of an 8-bit map.
    U8(Vec<Level<u8>>),
    /// Of a 16-bit map.
    U16(Vec<Level<u16>>),
    /// Of a map of floats: exact, since a maximum is one of the values.
    F32(Vec<Level<f32>>),
}

/// A pyramid over a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Pyramid {
    bound: Bound,
    levels: Levels,
}

impl Pyramid {
    /// Builds all levels on all cores.
    #[must_use]
    pub fn new(heights: &Heights, bound: Bound) -> Self {
        let levels = match heights.texels() {
            Texels::U8(values) => Levels::U8(build(heights, values, bound)),
            Texels::U16(values) => Levels::U16(build(heights, values, bound)),
            Texels::F32(values) => Levels::F32(build(heights, values, bound)),
        };
        Self { bound, levels }
    }

    /// Brings the nodes over a rectangle of changed texels up to date: columns and rows, inside the map.
    ///
    /// # Panics
    /// If the map has another size or kind of texels than that which the pyramid was built from.
    pub fn update(&mut self, heights: &Heights, texels: [Range<u32>; 2]) {
        match (&mut self.levels, heights.texels()) {
            (Levels::U8(levels), Texels::U8(values)) => change(levels, heights, values, self.bound, texels),
            (Levels::U16(levels), Texels::U16(values)) => change(levels, heights, values, self.bound, texels),
            (Levels::F32(levels), Texels::F32(values)) => change(levels, heights, values, self.bound, texels),
            _ => panic!("a pyramid over another kind of texels"),
        }
    }

    /// The levels.
    #[must_use]
    pub fn levels(&self) -> &Levels {
        &self.levels
    }

    /// The levels by themselves.
    #[must_use]
    pub fn into_levels(self) -> Levels {
        self.levels
    }

    /// The bound of a node as a number that holds it exactly.
    ///
    /// # Panics
    /// If there is no such node.
    #[must_use]
    pub fn at(&self, level: usize, x: u32, y: u32) -> f64 {
        match &self.levels {
            Levels::U8(levels) => f64::from(levels[level].at(x, y)),
            Levels::U16(levels) => f64::from(levels[level].at(x, y)),
            Levels::F32(levels) => f64::from(levels[level].at(x, y)),
        }
    }

    /// Bytes of all levels together.
    #[must_use]
    pub fn bytes(&self) -> usize {
        fn of<T>(levels: &[Level<T>]) -> usize {
            levels.iter().map(|level| size_of_val(&level.values[..])).sum()
        }
        match &self.levels {
            Levels::U8(levels) => of(levels),
            Levels::U16(levels) => of(levels),
            Levels::F32(levels) => of(levels),
        }
    }
}

/// A quadtree of maxima over any values, the finest level first.
pub(super) fn maxima(finest: Level<f32>) -> Vec<Level<f32>> {
    let sizes = level_sizes(finest.size).skip(1);
    let coarser: Vec<_> = sizes.map(Level::blank).collect();
    let region = finest.whole();
    let mut levels: Vec<_> = std::iter::once(finest).chain(coarser).collect();
    climb::<Max, f32>(&mut levels, region);
    levels
}

/// Columns and rows of every level over a finest one, and of that itself first.
pub fn level_sizes(finest: [u32; 2]) -> impl Iterator<Item = [u32; 2]> {
    std::iter::successors(Some(finest), |size| (size[0] > 1 || size[1] > 1).then(|| size.map(|side| side.div_ceil(2))))
}

fn build<T: Height>(heights: &Heights, values: &[T], bound: Bound) -> Vec<Level<T>> {
    let size = heights.size();
    let width = size[0] as usize;
    let mut levels: Vec<Level<T>> = level_sizes(bound.nodes(heights)).map(Level::blank).collect();
    match bound {
        Bound::TexelMax => bands::build::<Max, T>(&mut levels, |y, row| {
            row.copy_from_slice(&values[y as usize * width..][..width]);
        }),
        Bound::CellMax => bands::build::<Max, T>(&mut levels, |y, row| cell_row::<Max, T>(values, size, y, 0, row)),
        Bound::CellMin => bands::build::<Min, T>(&mut levels, |y, row| cell_row::<Min, T>(values, size, y, 0, row)),
    }
    levels
}

fn change<T: Height>(levels: &mut [Level<T>], heights: &Heights, values: &[T], bound: Bound, texels: [Range<u32>; 2]) {
    if texels.iter().any(Range::is_empty) {
        return;
    }
    for region in bound.touched(heights, texels) {
        fill(levels, heights, values, bound, region);
    }
}

/// Fills the nodes over a region of the finest level.
fn fill<T: Height>(levels: &mut [Level<T>], heights: &Heights, values: &[T], bound: Bound, region: [Range<u32>; 2]) {
    match bound {
        Bound::TexelMax => {
            let width = heights.size()[0] as usize;
            for y in region[1].clone() {
                let columns =
                    y as usize * width + region[0].start as usize..y as usize * width + region[0].end as usize;
                levels[0].values[columns.clone()].copy_from_slice(&values[columns]);
            }
            climb::<Max, T>(levels, region);
        }
        Bound::CellMax => {
            cells::<Max, T>(values, heights.size(), &mut levels[0], &region);
            climb::<Max, T>(levels, region);
        }
        Bound::CellMin => {
            cells::<Min, T>(values, heights.size(), &mut levels[0], &region);
            climb::<Min, T>(levels, region);
        }
    }
}

/// The coarser levels over a region of the finest.
fn climb<E: Extreme, T: Height>(levels: &mut [Level<T>], mut region: [Range<u32>; 2]) {
    for index in 1..levels.len() {
        region = region.map(|range| range.start / 2..range.end.div_ceil(2));
        let (finer, coarser) = levels.split_at_mut(index);
        nodes::<E, T>(&finer[index - 1], &mut coarser[0], &region);
    }
}
