//! Bilinear and trilinear filters.

use super::{Image, Level, Sampler};
use crate::machine::texture::{Footprint, Sample};

pub(super) fn sample(image: &Image, sampler: Sampler, sample: &Sample) -> [f64; 4] {
    let finest = &image.levels[0];
    let lod = match sample.footprint {
        Footprint::Level(level) => level,
        Footprint::Gradient { ddx, ddy } => level(finest, ddx).max(level(finest, ddy)),
    };
    let last = image.levels.len() - 1;
    let lod = lod.clamp(0.0, last as f64);
    let layer = sample.layer.clamp(0, image.layers as i32 - 1) as u32;
    let at = |level: usize| texture_filter(&image.levels[level], sampler, sample, layer);
    if !sampler.linear_levels {
        return at((lod + 0.5).floor().min(last as f64) as usize);
    }
    let lower = lod.floor() as usize;
    mix(at(lower), at((lower + 1).min(last)), lod - lod.floor())
}

/// The level at which a change of the coordinates is one texel.
pub(super) fn level(finest: &Level, gradient: [f64; 2]) -> f64 {
    let texels = libm::hypot(gradient[0] * f64::from(finest.width), gradient[1] * f64::from(finest.height));
    libm::log2(texels.max(1e-30))
}

fn texture_filter(level: &Level, sampler: Sampler, sample: &Sample, layer: u32) -> [f64; 4] {
    let (x, y) = (position(sample.uv[0], level.width), position(sample.uv[1], level.height));
    let texel = |x: f64, y: f64| {
        let column = sampler.wrap.place(x as i64 + i64::from(sample.offset[0]), level.width);
        let row = sampler.wrap.place(y as i64 + i64::from(sample.offset[1]), level.height);
        level.texel(layer, column, row)
    };
    if !sampler.linear {
        return texel(x.floor(), y.floor());
    }
    let (x, y) = (x - 0.5, y - 0.5);
    let (left, top) = (x.floor(), y.floor());
    let upper = mix(texel(left, top), texel(left + 1.0, top), x - left);
    let lower = mix(texel(left, top + 1.0), texel(left + 1.0, top + 1.0), x - left);
    mix(upper, lower, y - top)
}

/// In texels; a coordinate that is no number is taken for 0.
fn position(coordinate: f64, size: u32) -> f64 {
    let position = coordinate * f64::from(size);
    if position.is_finite() { position } else { 0.0 }
}

pub(super) fn mix(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    std::array::from_fn(|i| a[i] * (1.0 - t) + b[i] * t)
}
