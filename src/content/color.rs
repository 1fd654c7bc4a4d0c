//! Colours: linear Rec. 709 until they are written.

use rayon::prelude::*;

use super::field::Field;

/// Linear red, green and blue.
pub type Rgb = [f32; 3];

/// An sRGB colour as painters write it, `0xRRGGBB`, made linear.
pub fn hex(code: u32) -> Rgb {
    [code >> 16, code >> 8, code].map(|byte| decode((byte & 255) as f32 / 255.0))
}

/// From sRGB's 0..1 to linear.
pub fn decode(x: f32) -> f32 {
    if x <= 0.040_45 { x / 12.92 } else { libm::powf((x + 0.055) / 1.055, 2.4) }
}

/// From linear to sRGB's 0..1.
pub fn encode(x: f32) -> f32 {
    if x <= 0.003_130_8 { x * 12.92 } else { 1.055 * libm::powf(x, 1.0 / 2.4) - 0.055 }
}

/// From one colour to another.
pub fn mix(a: Rgb, b: Rgb, t: f32) -> Rgb {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * t)
}

/// Brighter or darker.
pub fn scale(a: Rgb, factor: f32) -> Rgb {
    a.map(|x| x * factor)
}

/// One colour filtered by another.
pub fn filter(a: Rgb, b: Rgb) -> Rgb {
    std::array::from_fn(|i| a[i] * b[i])
}

/// Luminance of Rec. 709.
pub fn luminance(c: Rgb) -> f32 {
    0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]
}

/// 0 below `low`, 1 above `high`, smooth between; the edges may be reversed.
pub fn step(low: f32, high: f32, x: f32) -> f32 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A colour for each texel of a square tile.
#[derive(Clone, Debug)]
pub struct Paint {
    /// Texels along a side.
    pub size: usize,
    /// Row after row.
    pub data: Vec<Rgb>,
}

impl Paint {
    /// A colour for each texel from its column, row and tile coordinates.
    pub fn build(size: usize, color: impl Fn(usize, usize, f32, f32) -> Rgb + Sync) -> Self {
        let mut data = vec![[0.0; 3]; size * size];
        let step = 1.0 / size as f32;
        data.par_chunks_mut(size).enumerate().for_each(|(y, row)| {
            for (x, texel) in row.iter_mut().enumerate() {
                *texel = color(x, y, (x as f32 + 0.5) * step, (y as f32 + 0.5) * step);
            }
        });
        Self { size, data }
    }

    /// Half the size: each texel the mean of four.
    pub fn halved(&self) -> Self {
        let at = |x: usize, y: usize| self.data[y * self.size + x];
        Self::build(self.size / 2, |x, y, _, _| {
            let (x, y) = (2 * x, 2 * y);
            let four = [at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)];
            std::array::from_fn(|i| four.iter().map(|c| c[i]).sum::<f32>() * 0.25)
        })
    }

    /// The mean luminance over all texels.
    pub fn mean(&self) -> f32 {
        (self.data.iter().map(|&c| f64::from(luminance(c))).sum::<f64>() / self.data.len() as f64) as f32
    }

    /// Scaled to a mean luminance, without blotches longer than a length in texels that would show the tile's grid.
    pub fn evened(mut self, length: f32, mean: f32) -> Self {
        let light = Field { size: self.size, data: self.data.iter().map(|&c| luminance(c)).collect() };
        let low = light.blurred(length);
        self.data.par_iter_mut().zip(&low.data).for_each(|(c, &low)| {
            // A third of the blotches may stay: a perfectly even tile looks printed.
            let factor = libm::powf(mean / low.max(1e-4), 0.67);
            *c = scale(*c, factor);
        });
        let factor = mean / self.mean().max(1e-6);
        self.data.par_iter_mut().for_each(|c| *c = scale(*c, factor).map(|x| x.clamp(0.0, 1.0)));
        self
    }
}
