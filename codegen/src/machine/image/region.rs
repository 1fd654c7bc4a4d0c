//! Bounds of all samples in a region.

use super::filter::{level, mix};
use super::{Image, Level, Sampler};
use crate::machine::texture::{Footprint, Region, Within};

/// How far the level of a given one may be off: its fraction has few bits.
const LEVEL_DOUBT: f64 = 1.0 / 64.0;
/// How far the level of a footprint may be off: hardware approximates the length of the gradients.
const GRADIENT_DOUBT: f64 = 0.75;
/// How far a position may be off, in texels: hardware has 8 bits for the place between two texels.
const PLACE_DOUBT: f64 = 1.0 / 128.0;
/// Cells of four texels that are looked at one by one; beyond, the bounds of all texels serve.
const CELLS: i64 = 64;

/// The bounds of what a filter may give, in all levels that may take part.
pub(super) fn bounds(image: &Image, sampler: Sampler, region: &Region) -> [Within; 4] {
    let last = image.levels.len() as i32 - 1;
    let (levels, reach) = span(image, sampler, region);
    let bound = |lod: f64| if lod.is_nan() { 0 } else { lod.clamp(0.0, f64::from(last)) as i32 };
    let (first, final_level) = match levels.low.is_nan() || levels.high.is_nan() {
        true => (0, last),
        false => (bound(levels.low.floor()), bound(levels.high.ceil())),
    };
    let layer = |layer: i32| layer.clamp(0, image.layers as i32 - 1) as u32;
    let mut all = Vec::new();
    for index in first..=final_level {
        let level = &image.levels[index as usize];
        let axes = [0, 1].map(|axis| positions(level, region, axis, reach[axis]));
        for layer in layer(region.layers.0)..=layer(region.layers.1) {
            all.extend(extremes(level, sampler, region, layer, axes));
        }
    }
    let widen = |within: Within| Within { low: within.low - image.doubt, high: within.high + image.doubt };
    hull(all.into_iter()).map(widen)
}

/// The levels of detail that the samples may have, and how far to either side of the coordinates they reach.
fn span(image: &Image, sampler: Sampler, region: &Region) -> (Within, [f64; 2]) {
    match region.footprint {
        Footprint::Level(level) => (Within { low: level.low - LEVEL_DOUBT, high: level.high + LEVEL_DOUBT }, [0.0; 2]),
        Footprint::Gradient { ddx, ddy } => {
            let finest = &image.levels[0];
            let widest = |of: [Within; 2]| of.map(|range| range.low.abs().max(range.high.abs()));
            let (x, y) = (widest(ddx), widest(ddy));
            let coarsest = level(finest, x).max(level(finest, y)) + GRADIENT_DOUBT;
            if sampler.anisotropy > 1 {
                // Any finer level, and anywhere along the footprint.
                return (Within { low: 0.0, high: coarsest }, [x[0] + y[0], x[1] + y[1]]);
            }
            let narrowest =
                |of: [Within; 2]| of.map(|range| if range.low > 0.0 { range.low } else { (-range.high).max(0.0) });
            let low = level(finest, narrowest(ddx)).max(level(finest, narrowest(ddy))) - GRADIENT_DOUBT;
            (Within { low, high: coarsest }, [0.0; 2])
        }
    }
}

/// The positions on an axis in texels, from which the texel and the weights follow.
fn positions(level: &Level, region: &Region, axis: usize, reach: f64) -> Within {
    let size = f64::from([level.width, level.height][axis]);
    let of = |coordinate: f64, outward: f64| {
        let position = coordinate * size;
        // Coordinates are `f32`: far from 0 their own grid shows.
        position + outward * (reach * size + PLACE_DOUBT + position.abs() * f64::from(f32::EPSILON))
    };
    Within { low: of(region.uv[axis].low, -1.0), high: of(region.uv[axis].high, 1.0) }
}

/// Values among which are the extremes of the filter over a box of positions.
fn extremes(level: &Level, sampler: Sampler, region: &Region, layer: u32, axes: [Within; 2]) -> Vec<[f64; 4]> {
    // Texels for the nearest filter; for the linear one cells between their centres.
    let shift = if sampler.linear { 0.5 } else { 0.0 };
    let cells = axes.map(|axis| ((axis.low - shift).floor(), (axis.high - shift).floor()));
    let count: f64 = cells.iter().map(|(low, high)| high - low + 1.0).product();
    if !count.is_finite() || count > CELLS as f64 {
        return (0..level.height).flat_map(|y| (0..level.width).map(move |x| level.texel(layer, x, y))).collect();
    }
    let texel = |x: f64, y: f64| {
        let column = sampler.wrap.place(x as i64 + i64::from(region.offset[0]), level.width);
        let row = sampler.wrap.place(y as i64 + i64::from(region.offset[1]), level.height);
        level.texel(layer, column, row)
    };
    let mut values = Vec::new();
    for x in steps(cells[0]) {
        for y in steps(cells[1]) {
            if !sampler.linear {
                values.push(texel(x, y));
                continue;
            }
            // Inside a cell the filter is linear along each axis: its extremes are at the corners of the box.
            let [across, down] = [(axes[0], x), (axes[1], y)]
                .map(|(axis, cell)| [axis.low, axis.high].map(|at| (at - shift - cell).clamp(0.0, 1.0)));
            let rows = [y, y + 1.0].map(|y| across.map(|t| mix(texel(x, y), texel(x + 1.0, y), t)));
            values.extend([0, 1].into_iter().flat_map(|i| down.map(|t| mix(rows[0][i], rows[1][i], t))));
        }
    }
    values
}

fn steps((low, high): (f64, f64)) -> impl Iterator<Item = f64> {
    (0..=(high - low) as u32).map(move |step| low + f64::from(step))
}

/// The bounds of each channel.
pub(super) fn hull(texels: impl Iterator<Item = [f64; 4]>) -> [Within; 4] {
    let empty = [Within { low: f64::INFINITY, high: f64::NEG_INFINITY }; 4];
    texels.fold(empty, |hull, texel| {
        std::array::from_fn(|i| Within { low: hull[i].low.min(texel[i]), high: hull[i].high.max(texel[i]) })
    })
}
