//! Bounds of all samples in a region.

use super::filter::level;
use super::{Image, Sampler};
use crate::machine::texture::{Footprint, Region, Within};

/// How far implementations may differ in the level they choose: gradients are approximated by up to half a level, and
/// anisotropic filters take finer levels than isotropic ones.
const LEVEL_DOUBT: f64 = 1.0;

/// The bounds of the texels that may take part in a sample, in all levels that may.
pub(super) fn bounds(image: &Image, sampler: Sampler, region: &Region) -> [Within; 4] {
    let last = image.levels.len() as i32 - 1;
    let finest = &image.levels[0];
    let (low, high, reach) = match region.footprint {
        Footprint::Level(level) => (level.low - LEVEL_DOUBT, level.high + LEVEL_DOUBT, [0.0; 2]),
        Footprint::Gradient { ddx, ddy } => {
            let widest = |of: [Within; 2]| of.map(|range| range.low.abs().max(range.high.abs()));
            let (x, y) = (widest(ddx), widest(ddy));
            let coarsest = level(finest, x).max(level(finest, y));
            // Half the footprint on either side, and as much again for what implementations make of it.
            (f64::NEG_INFINITY, coarsest + LEVEL_DOUBT, [x[0] + y[0], x[1] + y[1]])
        }
    };
    let bound = |lod: f64, default: i32| if lod.is_nan() { default } else { lod.clamp(0.0, f64::from(last)) as i32 };
    let levels = bound(low.floor(), 0)..=bound(high.ceil(), last);
    let layer = |layer: i32| layer.clamp(0, image.layers as i32 - 1) as u32;
    let layers = layer(region.layers.0)..=layer(region.layers.1);
    let texels = levels.flat_map(|index| {
        let level = &image.levels[index as usize];
        let columns = places(level.width, sampler, region, 0, reach);
        let rows = places(level.height, sampler, region, 1, reach);
        let layers = layers.clone();
        layers.flat_map(move |layer| {
            let columns = columns.clone();
            rows.clone()
                .into_iter()
                .flat_map(move |row| columns.clone().into_iter().map(move |column| level.texel(layer, column, row)))
        })
    });
    hull(texels)
}

/// The columns or rows that a sample in the region may touch.
fn places(size: u32, sampler: Sampler, region: &Region, axis: usize, reach: [f64; 2]) -> Vec<u32> {
    let texels = f64::from(size);
    // One texel more on either side: weights of filters and coordinates are of limited precision.
    let low = (region.uv[axis].low - reach[axis]) * texels - 1.5;
    let high = (region.uv[axis].high + reach[axis]) * texels + 1.5;
    let offset = i64::from(region.offset[axis]);
    if !(high - low).is_finite() || high - low >= 2.0 * texels {
        return (0..size).collect();
    }
    let mut places: Vec<u32> = (low.floor() as i64 + offset..=high.floor() as i64 + offset)
        .map(|place| sampler.wrap.place(place, size))
        .collect();
    places.sort_unstable();
    places.dedup();
    places
}

/// The bounds of each channel.
pub(super) fn hull(texels: impl Iterator<Item = [f64; 4]>) -> [Within; 4] {
    let empty = [Within { low: f64::INFINITY, high: f64::NEG_INFINITY }; 4];
    texels.fold(empty, |hull, texel| {
        std::array::from_fn(|i| Within { low: hull[i].low.min(texel[i]), high: hull[i].high.max(texel[i]) })
    })
}
