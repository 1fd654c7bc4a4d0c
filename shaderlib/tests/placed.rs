//! A part of a placed map that has changed, against the whole placed anew.

use terrane_shaderlib::heightfield::adversary::{Depth, LANDS, Random, SIZES, map};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::relief::{Bounds, Placed, Region};

/// Rectangles at corners, along borders, of one texel, inside, and of everything.
fn rectangles([width, height]: [u32; 2], random: &mut Random) -> Vec<Region> {
    let mut any = |side: u32| {
        let [a, b] = [(); 2].map(|()| random.between(0, i64::from(side) - 1) as u32);
        a.min(b)..a.max(b) + 1
    };
    let inside = [any(width), any(height)];
    let corners =
        [[0..1, 0..1], [width - 1..width, 0..1], [0..1, height - 1..height], [width - 1..width, height - 1..height]];
    let borders = [[0..width, 0..1], [width - 1..width, 0..height], [0..width.div_ceil(2), 0..height]];
    corners.into_iter().chain(borders).chain([inside, [0..width, 0..height], [0..0, 0..height]]).collect()
}

/// The map with the texels of a rectangle from another of its size.
fn patched(heights: &Heights, other: &Heights, [columns, rows]: &Region) -> Heights {
    let (Texels::U16(values), Texels::U16(others)) = (heights.texels(), other.texels()) else { panic!("16-bit maps") };
    let mut values = values.clone();
    for y in rows.clone() {
        for x in columns.clone() {
            let at = (y * heights.size()[0] + x) as usize;
            values[at] = others[at];
        }
    }
    Heights::new(heights.size(), heights.border(), Texels::U16(values)).expect("the size of a map")
}

#[test]
fn an_updated_part_equals_the_whole_placed_anew() {
    let mut random = Random::new(3);
    for border in [Border::Wrap, Border::Clamp] {
        for (index, size) in SIZES.into_iter().enumerate() {
            let mut make = |land: usize| {
                map(LANDS[land % LANDS.len()], size, border, Depth::Sixteen, random.bits()).expect("a map")
            };
            let (mut heights, other) = (make(index), make(index + 6));
            let mut placed = Placed::new(&heights, Bounds::CellMax, 9).expect("whole steps");
            for rectangle in rectangles(size, &mut random) {
                heights = patched(&heights, &other, &rectangle);
                placed.update(&heights, Bounds::CellMax, &rectangle);
                let anew = Placed::new(&heights, Bounds::CellMax, 9).expect("whole steps");
                assert!(placed == anew, "{size:?} {border:?} {rectangle:?}");
            }
        }
    }
}
