//! Filters on wrapping grids: blur, cavity, slope, sky visibility.

use rayon::prelude::*;

use super::field::Field;

impl Field {
    /// Close to a Gaussian with a standard deviation in texels: three boxes, one after the other.
    pub fn blurred(&self, deviation: f32) -> Self {
        let radius = ((4.0 * deviation * deviation + 1.0).sqrt() * 0.5 - 0.5).round() as usize;
        if radius == 0 {
            return self.clone();
        }
        let radius = radius.min((self.size - 1) / 2);
        (0..2).fold(self.clone(), |mut field, _| {
            for _ in 0..3 {
                field = field.boxed_rows(radius);
            }
            field.transposed()
        })
    }

    fn boxed_rows(&self, radius: usize) -> Self {
        let n = self.size;
        let mut data = vec![0.0; n * n];
        let scale = 1.0 / (2 * radius + 1) as f64;
        data.par_chunks_mut(n).zip(self.data.par_chunks(n)).for_each(|(out, row)| {
            let mut sum: f64 = (0..=2 * radius).map(|i| f64::from(row[(i + n - radius) % n])).sum();
            for x in 0..n {
                out[x] = (sum * scale) as f32;
                sum += f64::from(row[(x + radius + 1) % n]) - f64::from(row[(x + n - radius) % n]);
            }
        });
        Self { size: n, data }
    }

    /// Rows become columns.
    pub fn transposed(&self) -> Self {
        Self::texels(self.size, |x, y| self.at(y, x))
    }

    /// How far each texel stands above its surroundings of a radius in texels; negative in hollows.
    pub fn above(&self, radius: f32) -> Self {
        self.zip(&self.blurred(radius), |x, mean| x - mean)
    }

    /// Without what changes over more than a length in texels, where `keep` is 0; untouched where it is 1.
    pub fn evened(&self, length: f32, keep: f32) -> Self {
        let mean = self.data.iter().map(|&x| f64::from(x)).sum::<f64>() / self.data.len() as f64;
        self.zip(&self.blurred(length), |x, low| x - (low - mean as f32) * (1.0 - keep))
    }

    /// Slope along columns and rows, per texel, over two texels.
    pub fn gradient(&self, x: usize, y: usize) -> (f32, f32) {
        let n = self.size;
        let (left, right) = (self.at((x + n - 1) % n, y), self.at((x + 1) % n, y));
        let (up, down) = (self.at(x, (y + n - 1) % n), self.at(x, (y + 1) % n));
        (0.5 * (right - left), 0.5 * (down - up))
    }

    /// The part of the sky that each texel sees over its surroundings, 0..1; `depth` is the height of 1 in texels.
    pub fn sky(&self, depth: f32, reach: f32) -> Self {
        let n = self.size as i32;
        let steps = sky_steps(reach);
        Self::texels(self.size, |x, y| {
            let here = self.at(x, y);
            let mut open = 0.0;
            for direction in &steps {
                let mut tangent = 0.0_f32;
                for &(dx, dy, inverse) in direction {
                    let other = self.at((x as i32 + dx).rem_euclid(n) as usize, (y as i32 + dy).rem_euclid(n) as usize);
                    tangent = tangent.max((other - here) * inverse);
                }
                let tangent = tangent * depth;
                open += 1.0 / (1.0 + tangent * tangent);
            }
            open / steps.len() as f32
        })
    }
}

/// For 8 directions: offsets at growing distances, and one over the distance.
fn sky_steps(reach: f32) -> Vec<Vec<(i32, i32, f32)>> {
    (0..8)
        .map(|i| {
            let angle = (i as f32 + 0.3) * (std::f32::consts::TAU / 8.0);
            let (cos, sin) = (libm::cosf(angle), libm::sinf(angle));
            let mut steps = Vec::new();
            let mut distance = 1.5;
            while distance <= reach {
                let (dx, dy) = ((cos * distance).round() as i32, (sin * distance).round() as i32);
                steps.push((dx, dy, 1.0 / ((dx * dx + dy * dy) as f32).sqrt()));
                distance *= 1.6;
            }
            steps
        })
        .collect()
}
