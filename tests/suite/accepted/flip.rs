//! How different two pictures look (Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", 2020).

use nv_flip::{DEFAULT_PIXELS_PER_DEGREE, FlipImageRgb8, FlipPool, flip, magma_lut};

use crate::picture::Picture;

/// Largest mean difference: drivers round differently, a person sees nothing.
const MEAN: f32 = 0.01;
/// Largest difference of all but the worst hundredth of the pixels.
const P99: f32 = 0.10;

/// The difference of two pictures of equal size.
pub(super) struct Difference {
    pub(super) mean: f32,
    pub(super) p99: f32,
    /// Dark where they are alike.
    pub(super) map: Picture,
}

impl Difference {
    pub(super) fn of(known: &Picture, found: &Picture) -> Self {
        let image =
            |picture: &Picture| FlipImageRgb8::with_data(picture.width, picture.height, picture.pixels.as_flattened());
        let errors = flip(image(known), image(found), DEFAULT_PIXELS_PER_DEGREE);
        let mut pool = FlipPool::from_image(&errors);
        let colors = errors.apply_color_lut(&magma_lut()).to_vec();
        let pixels = colors.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        let map = Picture { width: known.width, height: known.height, pixels };
        Self { mean: pool.mean(), p99: pool.get_percentile(0.99, false), map }
    }

    pub(super) fn is_small(&self) -> bool {
        self.mean <= MEAN && self.p99 <= P99
    }
}

#[cfg(test)]
mod tests {
    use super::Difference;
    use crate::picture::Picture;

    fn picture(pixel: impl Fn(u32, u32) -> u8) -> Picture {
        let pixels = (0..64 * 32).map(|at| [pixel(at % 64, at / 64); 3]).collect();
        Picture { width: 64, height: 32, pixels }
    }

    fn stripes(x: u32) -> u8 {
        if (x / 8).is_multiple_of(2) { 60 } else { 190 }
    }

    #[test]
    fn rounding_is_small_but_a_shift_or_a_tone_is_not() {
        let known = picture(|x, _| stripes(x));
        let rounded = picture(|x, y| stripes(x) + u8::from((x * 7 + y * 13).is_multiple_of(16)));
        let shifted = picture(|x, _| stripes(x + 1));
        let brighter = picture(|x, _| stripes(x) + 12);
        let cases = [
            ("same", &known, true),
            ("rounded", &rounded, true),
            ("shifted", &shifted, false),
            ("brighter", &brighter, false),
        ];
        for (name, found, small) in cases {
            let difference = Difference::of(&known, found);
            assert_eq!(difference.is_small(), small, "{name}: {} {}", difference.mean, difference.p99);
        }
    }
}
