//! The reference for shadow and occlusion, in f64: how high the land stands around a point, exactly, and what share of the
//! sun and of the sky that leaves.
//!
//! A height field hides, in each vertical plane, what lies below one line of sight: its horizon. Everything here is an
//! integral over horizons, dense enough that more of them change nothing.

mod horizon;
mod sky;
mod sun;

pub use sun::Sun;

use super::Heights;

/// A map as land under the sky.
#[derive(Clone, Copy, Debug)]
pub struct Visibility<'a> {
    heights: &'a Heights,
    /// Steps of height that are as long as a texel is wide.
    steps: f64,
    /// No texel is higher.
    lid: f64,
}

impl<'a> Visibility<'a> {
    /// Of a map on which so many steps of height are as long as a texel is wide. Looks at every texel once.
    #[must_use]
    pub fn new(heights: &'a Heights, steps: f64) -> Self {
        Self { heights, steps, lid: heights.highest() }
    }

    /// Rise over run of the surface along x and y; on a border of cells, that of the cell which begins there.
    #[must_use]
    pub fn gradient(&self, x: f64, y: f64) -> [f64; 2] {
        let (i, j) = (x.floor(), y.floor());
        let (u, v) = (x - i, y - j);
        let [a, b, c, d] = self.heights.corners(i as i64, j as i64);
        let rise = [(b - a) * (1.0 - v) + (d - c) * v, (c - a) * (1.0 - u) + (d - b) * u];
        rise.map(|steps| steps / self.steps)
    }

    /// The normal of that, z up.
    #[must_use]
    pub fn normal(&self, x: f64, y: f64) -> [f64; 3] {
        let [a, b] = self.gradient(x, y);
        let length = (a * a + b * b + 1.0).sqrt();
        [-a / length, -b / length, 1.0 / length]
    }
}

#[cfg(test)]
mod tests;
