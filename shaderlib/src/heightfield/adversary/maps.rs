//! Maps that methods fail on.

use super::random::Random;
use crate::heightfield::{Border, Heights, HeightsError, Texels};

/// What a map is like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Land {
    /// 0 everywhere.
    Low,
    /// The highest number everywhere: bounds and surface are the same.
    High,
    /// Single texels of the highest number on 0, one in 16.
    Needles,
    /// Walls one texel wide on one side of each 4th, 16th or 64th border, where nodes of a pyramid meet: as far apart as
    /// the map is wide, or less.
    Walls,
    /// A wall one texel wide along the first or the last column and row: where a wrapped map meets itself.
    Seam,
    /// 0 and the highest number in turns: every cell is a saddle as deep as can be.
    Checkerboard,
    /// Every texel by itself.
    Noise,
    /// Smooth hills.
    Hills,
    /// Steps of 5 × 7 texels, with cracks to 0 between them.
    Cracks,
}

/// Every kind of land.
pub const LANDS: [Land; 9] = {
    use Land::{Checkerboard, Cracks, High, Hills, Low, Needles, Noise, Seam, Walls};
    [Low, High, Needles, Walls, Seam, Checkerboard, Noise, Hills, Cracks]
};

/// Columns and rows: the smallest, powers of 4 and of 2, one more and one less, what divides by none, and long ones.
pub const SIZES: [[u32; 2]; 14] = {
    let small = [[1, 1], [2, 2], [3, 3], [1, 5], [4, 1], [4, 4], [7, 5]];
    let large = [[16, 16], [17, 31], [15, 64], [64, 64], [65, 33], [100, 36], [6, 128]];
    let mut all = [[0; 2]; 14];
    let mut at = 0;
    while at < 7 {
        (all[at], all[at + 7]) = (small[at], large[at]);
        at += 1;
    }
    all
};

/// Bits of a height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// 0..255.
    Eight,
    /// 0..65535.
    Sixteen,
}

/// A map, always the same from the same seed.
///
/// # Errors
/// Where the size is none that a map can have.
pub fn map(land: Land, size: [u32; 2], border: Border, depth: Depth, seed: u64) -> Result<Heights, HeightsError> {
    let places = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y]));
    let variant = Random::new(seed).bits();
    let heights = places.map(|place| height(land, place, size, variant));
    let texels = match depth {
        Depth::Eight => Texels::U8(heights.map(|height| (height >> 8) as u8).collect()),
        Depth::Sixteen => Texels::U16(heights.collect()),
    };
    Heights::new(size, border, texels)
}

fn height(land: Land, [x, y]: [u32; 2], [width, height]: [u32; 2], variant: u64) -> u16 {
    let full = |high: bool| if high { u16::MAX } else { 0 };
    let side = (variant & 1) as u32;
    match land {
        Land::Low => 0,
        Land::High => u16::MAX,
        Land::Needles => full(hash(x, y, variant) & 15 == 0),
        Land::Walls => {
            let every =
                [64, 16].into_iter().skip((variant >> 1) as usize % 3).find(|every| *every <= width).unwrap_or(4);
            let wall = |at: u32| (at + side).is_multiple_of(every);
            full(wall(x) || variant & 8 != 0 && wall(y))
        }
        Land::Seam => full(x == side * (width - 1) || y == side * (height - 1)),
        Land::Checkerboard => full((x ^ y) & 1 == side),
        Land::Noise => hash(x, y, variant) as u16,
        Land::Hills => hill([x, y], [width, height], variant),
        Land::Cracks if x.is_multiple_of(5) || y.is_multiple_of(7) => 0,
        Land::Cracks => 16_384 + (hash(x / 5, y / 7, variant) >> 50) as u16,
    }
}

fn hash(x: u32, y: u32, variant: u64) -> u64 {
    Random::new(variant ^ Random::new(u64::from(y) << 32 | u64::from(x)).bits()).bits()
}

/// Between 3 × 3 random heights a tile, with flat tops; it tiles.
fn hill(place: [u32; 2], size: [u32; 2], variant: u64) -> u16 {
    let scaled = [0, 1].map(|axis| f64::from(place[axis]) * 3.0 / f64::from(size[axis]));
    let [(i, u), (j, v)] = scaled.map(|at| (at as u32, smooth(at - at.floor())));
    let corner = |x: u32, y: u32| (hash(x % 3, y % 3, variant) >> 48) as f64;
    let row = |y: u32| corner(i, y) * (1.0 - u) + corner(i + 1, y) * u;
    (row(j) * (1.0 - v) + row(j + 1) * v) as u16
}

fn smooth(s: f64) -> f64 {
    s * s * (3.0 - 2.0 * s)
}
