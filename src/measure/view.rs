//! The rays of a view.

use terrane_shaderlib::heightfield::{Heights, Ray};

use crate::relief::Segment;

/// A window that looks down on a tile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Degrees above the ground.
    pub elevation: f64,
    /// How deep the relief is, over the length of the tile's first side.
    pub depth: f64,
    /// Columns and rows of rays, multiples of 8.
    pub size: [u32; 2],
}

impl View {
    /// Texels to a step of height, of which `full` make the depth.
    #[must_use]
    pub fn scale(&self, heights: &Heights, full: f64) -> f64 {
        self.depth * f64::from(heights.size()[0]) / full
    }

    /// Rays from the lid of the relief to a little under its floor, in blocks of 8 x 8 neighbours as a GPU has them. Heights
    /// count in steps, of which `full` make the depth.
    #[must_use]
    pub fn rays(&self, heights: &Heights, full: f64) -> Vec<Segment> {
        let [columns, rows] = self.size.map(|side| (side / 8).max(1));
        let blocks = (0..rows).flat_map(|y| (0..columns).map(move |x| [8 * x, 8 * y]));
        let pixels = blocks.flat_map(|[x, y]| (0..64).map(move |index| [x + index % 8, y + index / 8]));
        pixels.map(|pixel| self.ray(pixel, heights, full)).collect()
    }

    fn ray(&self, pixel: [u32; 2], heights: &Heights, full: f64) -> Segment {
        let [u, v] = [0, 1].map(|axis| (f64::from(pixel[axis]) + 0.5) / f64::from(self.size[axis]));
        // A lens: directions differ across the view by some degrees, and none is that of an axis or a diagonal.
        let azimuth = 0.6 + 0.5 * (u - 0.5);
        let elevation = (self.elevation * (1.0 + 0.3 * (v - 0.5))).to_radians();
        let [width, height] = heights.size().map(f64::from);
        let steps = 1.0 / self.scale(heights, full);
        let direction = [azimuth.cos() * elevation.cos(), azimuth.sin() * elevation.cos(), -elevation.sin() * steps];
        let origin = [width * (0.1 + 0.8 * u), height * (0.1 + 0.8 * v), full];
        Segment { ray: Ray { origin, direction }, range: (0.0, (full + 2.0) / -direction[2]) }
    }
}
