//! One level of a pyramid.

use std::ops::Range;

/// A grid of values, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Level<T> {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Row after row.
    pub values: Vec<T>,
}

/// Columns and rows of a level.
pub(super) type Region = [Range<u32>; 2];

impl<T: Copy + Default> Level<T> {
    /// A level that is still to be filled. Of zeros, which the system hands out without writing them.
    pub(super) fn blank(size: [u32; 2]) -> Self {
        Self { size, values: vec![T::default(); size[0] as usize * size[1] as usize] }
    }
}

impl<T: Copy> Level<T> {
    /// The value at a column and row.
    ///
    /// # Panics
    /// If there is none.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> T {
        self.row(y)[x as usize]
    }

    /// The values of a row.
    pub(super) fn row(&self, y: u32) -> &[T] {
        let width = self.size[0] as usize;
        &self.values[y as usize * width..][..width]
    }

    /// All of it.
    pub(super) fn whole(&self) -> Region {
        self.size.map(|side| 0..side)
    }
}
