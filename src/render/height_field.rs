//! The shape of a terrain: one height per texel, the bilinear surface between texel centres.

use super::error::{RenderError, Result};

/// A height map in metres.
///
/// Texel (i, j) is the height at x = (i + ½)·spacing.x east and z = (j + ½)·spacing.z south of the north-west corner,
/// as in every texture that lies over the terrain. Outside the outermost centres the border's height goes on.
#[derive(Clone, Debug)]
pub struct HeightField {
    size: [u32; 2],
    spacing: [f64; 2],
    texels: Vec<f32>,
    range: [f32; 2],
}

impl HeightField {
    /// `texels` row by row from the north, each row from the west; `spacing` in metres between texels on x and z.
    ///
    /// # Errors
    /// [`RenderError::Scene`] for fewer than 2 or more than 8192 texels on a side (the limit of WebGPU's textures), a
    /// wrong number of texels, a spacing that is not positive, a height that is not finite or beyond 100 km.
    pub fn new(size: [u32; 2], spacing: [f64; 2], texels: Vec<f32>) -> Result<Self> {
        let refuse = |reason: String| Err(RenderError::Scene(format!("height map: {reason}")));
        if size.iter().any(|side| !(2..=8192).contains(side)) {
            return refuse(format!("{} x {} texels; each side must be 2..8192", size[0], size[1]));
        }
        if texels.len() != size[0] as usize * size[1] as usize {
            return refuse(format!("{} texels do not fill {} x {}", texels.len(), size[0], size[1]));
        }
        if spacing.iter().any(|metres| !(metres.is_finite() && *metres > 0.0)) {
            return refuse(format!("a spacing of {} x {} m is not positive", spacing[0], spacing[1]));
        }
        let range = texels.iter().fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], &h| [low.min(h), high.max(h)]);
        if texels.iter().any(|h| !h.is_finite()) || range[0] < -1e5 || range[1] > 1e5 {
            return refuse("a height is not finite, or beyond 100 km".into());
        }
        Ok(Self { size, spacing, texels, range })
    }

    /// Texels on x and z.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Metres between neighbouring texels on x and z.
    #[must_use]
    pub fn spacing(&self) -> [f64; 2] {
        self.spacing
    }

    /// Extent in metres on x and z.
    #[must_use]
    pub fn extent(&self) -> [f64; 2] {
        [0, 1].map(|axis| f64::from(self.size[axis]) * self.spacing[axis])
    }

    /// Lowest and highest texel in metres.
    #[must_use]
    pub fn range(&self) -> [f32; 2] {
        self.range
    }

    /// Every height, row by row.
    #[must_use]
    pub fn texels(&self) -> &[f32] {
        &self.texels
    }

    /// The height of a texel, the border's outside.
    #[must_use]
    pub fn at(&self, column: i64, row: i64) -> f32 {
        let column = column.clamp(0, i64::from(self.size[0]) - 1) as usize;
        let row = row.clamp(0, i64::from(self.size[1]) - 1) as usize;
        self.texels[row * self.size[0] as usize + column]
    }

    /// The height of a texel; beyond the border the terrain's mirror image goes on.
    #[must_use]
    pub fn mirrored(&self, column: i64, row: i64) -> f32 {
        let fold = |place: i64, side: u32| {
            let last = i64::from(side) - 1;
            if (0..=last).contains(&place) {
                return place as usize;
            }
            let place = place.rem_euclid(2 * last);
            place.min(2 * last - place) as usize
        };
        self.texels[fold(row, self.size[1]) * self.size[0] as usize + fold(column, self.size[0])]
    }

    /// The bilinear surface at a position in metres.
    #[must_use]
    pub fn bilinear(&self, x: f64, z: f64) -> f64 {
        let (u, v) = (x / self.spacing[0] - 0.5, z / self.spacing[1] - 0.5);
        let (column, row) = (u.floor(), v.floor());
        let (s, t) = (u - column, v - row);
        let texel = |i, j| f64::from(self.at(column as i64 + i, row as i64 + j));
        let north = texel(0, 0) * (1.0 - s) + texel(1, 0) * s;
        let south = texel(0, 1) * (1.0 - s) + texel(1, 1) * s;
        north * (1.0 - t) + south * t
    }

    /// Every second texel less: the mean of 2 × 2, the border repeated where a side is odd.
    #[must_use]
    pub fn halved(&self) -> Self {
        let size = self.size.map(|side| side.div_ceil(2).max(2));
        let mut texels = Vec::with_capacity(size[0] as usize * size[1] as usize);
        for row in 0..i64::from(size[1]) {
            for column in 0..i64::from(size[0]) {
                let texel = |i, j| self.at(2 * column + i, 2 * row + j);
                texels.push((texel(0, 0) + texel(1, 0) + texel(0, 1) + texel(1, 1)) * 0.25);
            }
        }
        let spacing = self.spacing.map(|metres| 2.0 * metres);
        Self { size, spacing, texels, range: self.range }
    }
}
