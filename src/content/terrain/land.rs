//! The ground during its making: heights in metres on a square grid that ends at its borders.

use rayon::prelude::*;

use super::super::field::Field;
use super::super::noise::Noise;

/// Heights.
#[derive(Clone, Debug)]
pub struct Land {
    /// Cells along a side.
    pub size: usize,
    /// Side of a cell, metres.
    pub cell: f32,
    /// Metres, row after row.
    pub height: Vec<f32>,
}

/// The eight neighbours: column, row, distance in cells.
pub const NEIGHBOURS: [(i32, i32, f32); 8] = [
    (-1, 0, 1.0),
    (1, 0, 1.0),
    (0, -1, 1.0),
    (0, 1, 1.0),
    (-1, -1, std::f32::consts::SQRT_2),
    (1, -1, std::f32::consts::SQRT_2),
    (-1, 1, std::f32::consts::SQRT_2),
    (1, 1, std::f32::consts::SQRT_2),
];

impl Land {
    /// A height for each cell from the coordinates of its centre, 0..1.
    pub fn build(size: usize, extent: f32, height: impl Fn(f32, f32) -> f32 + Sync) -> Self {
        Self { size, cell: extent / size as f32, height: Field::build(size, height).data }
    }

    /// The neighbours of a cell that lie on the land: which of the eight, index, distance in cells.
    pub fn around(&self, index: usize) -> impl Iterator<Item = (usize, usize, f32)> {
        let n = self.size as i32;
        let (x, y) = (index as i32 % n, index as i32 / n);
        NEIGHBOURS.into_iter().enumerate().filter_map(move |(direction, (dx, dy, distance))| {
            // As unsigned numbers, so that one comparison finds both borders.
            let inside = ((x + dx) as u32) < n as u32 && ((y + dy) as u32) < n as u32;
            inside.then(|| (direction, (index as i32 + dy * n + dx) as usize, distance))
        })
    }

    /// The cell at an offset, unless it lies outside.
    pub fn neighbour(&self, (x, y): (i32, i32), dx: i32, dy: i32) -> Option<usize> {
        let n = self.size as i32;
        let inside = ((x + dx) as u32) < n as u32 && ((y + dy) as u32) < n as u32;
        inside.then(|| ((y + dy) * n + x + dx) as usize)
    }

    /// A height; cells outside have that of the nearest border.
    pub fn at(&self, x: i32, y: i32) -> f32 {
        let n = self.size as i32;
        self.height[(y.clamp(0, n - 1) * n + x.clamp(0, n - 1)) as usize]
    }

    /// Twice as many cells along a side, by cubic interpolation (Catmull–Rom).
    pub fn refined(&self) -> Self {
        let size = self.size * 2;
        let mut height = vec![0.0; size * size];
        height.par_chunks_mut(size).enumerate().for_each(|(y, row)| {
            for (x, value) in row.iter_mut().enumerate() {
                *value = self.cubic(x as i32, y as i32);
            }
        });
        Self { size, cell: self.cell * 0.5, height }
    }

    /// The height at the centre of a cell of twice the resolution.
    fn cubic(&self, x: i32, y: i32) -> f32 {
        // The centre lies a quarter of a cell beside that of a coarse one; weights of Catmull–Rom at 1/4 and 3/4.
        const NEAR: [f32; 4] = [-0.070_312_5, 0.867_187_5, 0.226_562_5, -0.023_437_5];
        const FAR: [f32; 4] = [-0.023_437_5, 0.226_562_5, 0.867_187_5, -0.070_312_5];
        let (column, wx) = if x & 1 == 0 { (x / 2 - 2, FAR) } else { (x / 2 - 1, NEAR) };
        let (line, wy) = if y & 1 == 0 { (y / 2 - 2, FAR) } else { (y / 2 - 1, NEAR) };
        let across = |j: i32| (0..4).map(|i| wx[i as usize] * self.at(column + i, line + j)).sum::<f32>();
        (0..4).map(|j| wy[j as usize] * across(j)).sum()
    }

    /// The height at coordinates 0..1, between cells.
    pub fn sample(&self, u: f32, v: f32) -> f32 {
        let (x, y) = (u * self.size as f32 - 0.5, v * self.size as f32 - 0.5);
        let (fx, fy) = (x.floor(), y.floor());
        let (tx, ty) = (x - fx, y - fy);
        let (ix, iy) = (fx as i32, fy as i32);
        let row = |y: i32| self.at(ix, y) + (self.at(ix + 1, y) - self.at(ix, y)) * tx;
        row(iy) + (row(iy + 1) - row(iy)) * ty
    }

    /// Pushed about by a noise of a wavelength in metres: straight lines become crooked. Borders stay where they are.
    pub fn warped(&self, noise: &Noise, metres: f32) -> Self {
        let amount = metres / (self.cell * self.size as f32);
        Self::build(self.size, self.cell * self.size as f32, |u, v| {
            let inside = (20.0 * u.min(1.0 - u).min(v).min(1.0 - v)).min(1.0) * amount;
            self.sample(u + inside * noise.fbm(u, v), v + inside * noise.fbm(v + 0.31, u + 0.77))
        })
    }

    /// Rise per metre along columns and rows.
    pub fn gradient(&self, index: usize) -> (f32, f32) {
        let n = self.size;
        let (x, y) = ((index % n) as i32, (index / n) as i32);
        let scale = 0.5 / self.cell;
        ((self.at(x + 1, y) - self.at(x - 1, y)) * scale, (self.at(x, y + 1) - self.at(x, y - 1)) * scale)
    }

    /// Steepness: rise over run.
    pub fn steepness(&self) -> Vec<f32> {
        let each = |index| {
            let (gx, gy) = self.gradient(index);
            (gx * gx + gy * gy).sqrt()
        };
        (0..self.height.len()).into_par_iter().map(each).collect()
    }

    /// The heights as a grid.
    pub fn field(&self) -> Field {
        Field { size: self.size, data: self.height.clone() }
    }
}
