//! A square grid of numbers that wraps around: one channel of a tile.

use rayon::prelude::*;

/// `size`×`size` numbers by rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Texels along a side.
    pub size: usize,
    /// Row after row.
    pub data: Vec<f32>,
}

impl Field {
    /// The same number everywhere.
    pub fn filled(size: usize, value: f32) -> Self {
        Self { size, data: vec![value; size * size] }
    }

    /// A number for each texel from the tile coordinates of its centre, 0..1.
    pub fn build(size: usize, value: impl Fn(f32, f32) -> f32 + Sync) -> Self {
        let step = 1.0 / size as f32;
        Self::texels(size, |x, y| value((x as f32 + 0.5) * step, (y as f32 + 0.5) * step))
    }

    /// A number for each texel from its column and row.
    pub fn texels(size: usize, value: impl Fn(usize, usize) -> f32 + Sync) -> Self {
        let mut data = vec![0.0; size * size];
        data.par_chunks_mut(size).enumerate().for_each(|(y, row)| {
            for (x, texel) in row.iter_mut().enumerate() {
                *texel = value(x, y);
            }
        });
        Self { size, data }
    }

    /// A texel.
    pub fn at(&self, x: usize, y: usize) -> f32 {
        self.data[y * self.size + x]
    }

    /// A texel, around the corner if need be.
    pub fn wrapped(&self, x: i32, y: i32) -> f32 {
        let n = self.size as i32;
        self.at(x.rem_euclid(n) as usize, y.rem_euclid(n) as usize)
    }

    /// Between texels, by tile coordinates of any size.
    pub fn sample(&self, u: f32, v: f32) -> f32 {
        let (x, y) = (u * self.size as f32 - 0.5, v * self.size as f32 - 0.5);
        let (fx, fy) = (x.floor(), y.floor());
        let (tx, ty) = (x - fx, y - fy);
        let (ix, iy) = (fx as i32, fy as i32);
        let row = |y: i32| {
            let a = self.wrapped(ix, y);
            a + (self.wrapped(ix + 1, y) - a) * tx
        };
        let top = row(iy);
        top + (row(iy + 1) - top) * ty
    }

    /// A texel of a coarser grid that stands for a finer one, moved by a number of its own texels.
    pub fn coarse(&self, x: usize, y: usize, fine: usize, shift: u32) -> f32 {
        let factor = fine / self.size;
        let (dx, dy) = (shift as usize % 8191, shift as usize / 8191);
        self.at((x / factor + dx) % self.size, (y / factor + dy) % self.size)
    }

    /// Each number changed by itself.
    pub fn map(&self, f: impl Fn(f32) -> f32 + Sync) -> Self {
        Self { size: self.size, data: self.data.par_iter().map(|&x| f(x)).collect() }
    }

    /// Two grids, texel by texel.
    pub fn zip(&self, other: &Self, f: impl Fn(f32, f32) -> f32 + Sync) -> Self {
        let data = self.data.par_iter().zip(&other.data).map(|(&a, &b)| f(a, b)).collect();
        Self { size: self.size, data }
    }

    /// Half the size: each texel the mean of four.
    pub fn halved(&self) -> Self {
        Self::texels(self.size / 2, |x, y| {
            let (x, y) = (2 * x, 2 * y);
            0.25 * (self.at(x, y) + self.at(x + 1, y) + self.at(x, y + 1) + self.at(x + 1, y + 1))
        })
    }

    /// The number that a fraction of all texels is below.
    pub fn quantile(&self, fraction: f32) -> f32 {
        let mut sorted = self.data.clone();
        let rank = rank(sorted.len(), fraction);
        *sorted.select_nth_unstable_by(rank, f32::total_cmp).1
    }

    /// Stretched so that two quantiles come to 0 and 1, and what lies beyond is cut.
    pub fn normalised(&self, low: f32, high: f32) -> Self {
        let (low, high) = (self.quantile(low), self.quantile(high));
        let scale = 1.0 / (high - low).max(1e-9);
        self.map(|x| ((x - low) * scale).clamp(0.0, 1.0))
    }

    /// Stretched so that the least number is 0 and the greatest 1.
    pub fn stretched(&self) -> Self {
        self.normalised(0.0, 1.0)
    }
}

/// Where in so many sorted numbers a fraction of them is below. A last index of more than 24 bits is rounded up as a float.
fn rank(count: usize, fraction: f32) -> usize {
    let last = count - 1;
    ((last as f32 * fraction) as usize).min(last)
}

#[cfg(test)]
mod tests {
    use super::rank;

    #[test]
    fn the_last_of_as_many_texels_as_8192_by_8192_has_a_rank() {
        assert_eq!([rank(1 << 26, 1.0), rank(1 << 26, 0.0), rank(1, 1.0)], [(1 << 26) - 1, 0, 0]);
        assert_eq!(rank(11, 0.9), 9);
    }
}
