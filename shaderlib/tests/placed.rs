//! A part of a placed map that has changed, against the whole placed anew.

use std::collections::BTreeSet;

use terrane_shaderlib::heightfield::adversary::{Depth, LANDS, Random, SIZES, map};
use terrane_shaderlib::heightfield::cones::Cones;
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::relief::{Bounds, Method, Placed, Region};

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

/// Rectangles that become those of another map, one after the other.
fn update_again_and_again(mut heights: Heights, other: &Heights, bounds: Bounds, random: &mut Random) {
    let size = heights.size();
    let mut placed = Placed::new(&heights, bounds, 9).expect("whole steps");
    for rectangle in rectangles(size, random) {
        heights = patched(&heights, other, &rectangle);
        placed.update(&heights, bounds, &rectangle);
        let anew = Placed::new(&heights, bounds, 9).expect("whole steps");
        assert!(placed == anew, "{bounds:?} {size:?} {:?} {rectangle:?}", heights.border());
    }
}

#[test]
fn an_updated_part_equals_the_whole_placed_anew() {
    let mut random = Random::new(3);
    let all: BTreeSet<Bounds> = Method::all().into_iter().map(Method::bounds).collect();
    assert!(all.len() > 7, "{all:?}");
    for (border, bounds) in
        [Border::Wrap, Border::Clamp].iter().flat_map(|border| all.iter().map(move |one| (*border, *one)))
    {
        // Of bounds that reach far fewer maps, and larger ones.
        let far = !matches!(bounds, Bounds::CellMax | Bounds::TexelMax | Bounds::Patches);
        let sizes = SIZES.into_iter().step_by(if far { 3 } else { 1 });
        for (index, size) in sizes.chain(far.then_some([[128, 64], [70, 129]]).into_iter().flatten()).enumerate() {
            let mut make = |land: usize| {
                map(LANDS[land % LANDS.len()], size, border, Depth::Sixteen, random.bits()).expect("a map")
            };
            let (heights, other) = (make(index), make(index + 6));
            update_again_and_again(heights, &other, bounds, &mut random);
        }
    }
}

/// What alone narrows all cones, farther away than what is found again with it, comes and goes.
#[test]
fn a_peak_on_a_plain_comes_and_goes() {
    for (border, kind) in [Border::Wrap, Border::Clamp].into_iter().flat_map(|border| [1, 0].map(|kind| (border, kind)))
    {
        let size = [256, 128];
        let flat = Heights::new(size, border, Texels::U16(vec![7; 256 * 128])).expect("a map");
        let peak = Heights::new(size, border, Texels::U16(vec![50_000; 256 * 128])).expect("a map");
        let at = [200..201, 40..41];
        let with = patched(&flat, &peak, &at);
        let [before, after] = if kind == 0 { [&flat, &with] } else { [&with, &flat] };
        for bounds in [Bounds::Cells, Bounds::Quadrants, Bounds::Cones(Cones::Robust), Bounds::Cones(Cones::Step)] {
            let mut placed = Placed::new(before, bounds, 9).expect("whole steps");
            placed.update(after, bounds, &at);
            assert!(placed == Placed::new(after, bounds, 9).expect("whole steps"), "{bounds:?} {border:?} {kind}");
        }
    }
}
