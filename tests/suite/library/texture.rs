//! The texture that examples read: 4 by 4 texels, texel (x, y) = (x/3, y/3, (x+y) mod 2, 1), repeating, bilinear, one mip.

use std::sync::LazyLock;

use terrane_codegen::machine::{Image, Images, Sampler, Wrap};

/// The example texture and its sampler, both with id 0.
pub(super) static EXAMPLE: LazyLock<Images> = LazyLock::new(|| {
    let texels = (0..16).map(|index| texel(index % 4, index / 4)).collect();
    Images {
        images: vec![Image::new(4, 4, 1, texels).with_doubt(1.5 / 255.0)],
        samplers: vec![Sampler { wrap: Wrap::Repeat, linear: true, linear_levels: true, anisotropy: 1 }],
    }
});

fn texel(x: u32, y: u32) -> [f64; 4] {
    [f64::from(x) / 3.0, f64::from(y) / 3.0, f64::from((x + y) % 2), 1.0]
}

/// The same as bytes of `rgba8unorm`, which holds thirds exactly.
pub(super) fn example_bytes() -> Vec<u8> {
    (0..16).flat_map(|index| texel(index % 4, index / 4).map(|value| (value * 255.0).round() as u8)).collect()
}
