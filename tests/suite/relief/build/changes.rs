//! Rectangles of a map that become others.

use terrane_shaderlib::heightfield::adversary::Random;
use terrane_shaderlib::heightfield::{Heights, Texels};
use terrane_shaderlib::relief::Region;

/// Single texels at corners, columns and rows along borders, something inside, nothing, and anything.
pub(super) fn rectangles([width, height]: [u32; 2], random: &mut Random) -> Vec<Region> {
    let mut all = vec![
        [0..1, 0..1],
        [width - 1..width, height - 1..height],
        [0..1, height - 1..height],
        [width - 1..width, 0..height],
        [0..width, 0..1],
        [width / 3..width / 3 + 1, height / 2..(height / 2 + 3).min(height)],
        [0..0, 0..height],
    ];
    for _ in 0..3 {
        all.push([width, height].map(|side| {
            let first = random.between(0, i64::from(side) - 1);
            first as u32..random.between(first + 1, i64::from(side)) as u32
        }));
    }
    all
}

/// The map with other heights in a rectangle.
pub(super) fn changed(heights: &Heights, [columns, rows]: &Region, random: &mut Random) -> Heights {
    let width = heights.size()[0];
    let places = rows.clone().flat_map(|y| columns.clone().map(move |x| (y * width + x) as usize));
    let texels = match heights.texels().clone() {
        Texels::U8(mut values) => {
            places.for_each(|at| values[at] = random.bits() as u8);
            Texels::U8(values)
        }
        Texels::U16(mut values) => {
            places.for_each(|at| values[at] = random.bits() as u16);
            Texels::U16(values)
        }
        Texels::F32(mut values) => {
            places.for_each(|at| values[at] = float(random));
            Texels::F32(values)
        }
    };
    Heights::new(heights.size(), heights.border(), texels).expect("the size of a map")
}

/// A finite float: of any size, one of the smallest, or a zero of either sign.
pub(super) fn float(random: &mut Random) -> f32 {
    let bits = random.bits() as u32;
    let sign = bits & 1 << 31;
    match random.between(0, 3) {
        0 => f32::from_bits(sign),
        1 => f32::from_bits(sign | bits >> 9),
        // No exponent of an infinity.
        _ => f32::from_bits(if bits >> 23 & 0xff == 0xff { bits ^ 1 << 23 } else { bits }),
    }
}
