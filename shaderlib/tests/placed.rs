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

/// The map with the texels of a rectangle from another of its size and kind.
fn patched(heights: &Heights, other: &Heights, rectangle: &Region) -> Heights {
    let width = heights.size()[0];
    let texels = match (heights.texels(), other.texels()) {
        (Texels::U8(values), Texels::U8(others)) => Texels::U8(mixed(values, others, width, rectangle)),
        (Texels::U16(values), Texels::U16(others)) => Texels::U16(mixed(values, others, width, rectangle)),
        _ => panic!("maps of steps"),
    };
    Heights::new(heights.size(), heights.border(), texels).expect("the size of a map")
}

fn mixed<T: Copy>(values: &[T], others: &[T], width: u32, [columns, rows]: &Region) -> Vec<T> {
    let mut values = values.to_vec();
    for (x, y) in rows.clone().flat_map(|y| columns.clone().map(move |x| (x, y))) {
        let at = (y * width + x) as usize;
        values[at] = others[at];
    }
    values
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
            let depth = if index % 3 == 1 { Depth::Eight } else { Depth::Sixteen };
            let mut make =
                |land: usize| map(LANDS[land % LANDS.len()], size, border, depth, random.bits()).expect("a map");
            let (heights, other) = (make(index), make(index + 6));
            update_again_and_again(heights, &other, bounds, &mut random);
        }
    }
}

/// What alone narrows all cones, farther away than what is found again with it, comes and goes: within a map, at a seam of tiles, at
/// the end of a map, and where coarse nodes have more than one part.
#[test]
fn a_peak_on_a_plain_comes_and_goes() {
    let all = [
        Bounds::Cells,
        Bounds::Quadrants,
        Bounds::Cones(Cones::Robust),
        Bounds::Cones(Cones::Step),
        Bounds::Cones(Cones::Relaxed),
        Bounds::Cones(Cones::Quadrant(2)),
    ];
    let places = [
        (Border::Wrap, [256, 128], [200, 40], &all[..]),
        (Border::Clamp, [256, 128], [200, 40], &all),
        (Border::Wrap, [200, 100], [0, 0], &all),
        (Border::Clamp, [200, 100], [199, 99], &all),
        (Border::Wrap, [1024, 32], [0, 3], &all[..1]),
        (Border::Clamp, [1000, 32], [900, 31], &all[..1]),
    ];
    for (border, size, at, bounds) in places {
        let plain = |height: u16| {
            Heights::new(size, border, Texels::U16(vec![height; (size[0] * size[1]) as usize])).expect("a map")
        };
        let at = at.map(|at| at..at + 1);
        let (flat, peak) = (plain(7), patched(&plain(7), &plain(50_000), &at));
        for (bounds, [before, after]) in
            bounds.iter().flat_map(|bounds| [[&flat, &peak], [&peak, &flat]].map(|maps| (*bounds, maps)))
        {
            let mut placed = Placed::new(before, bounds, 9).expect("whole steps");
            placed.update(after, bounds, &at);
            let anew = Placed::new(after, bounds, 9).expect("whole steps");
            assert!(placed == anew, "{bounds:?} {border:?} {size:?} {at:?}");
        }
    }
}

/// Updates a map with other bounds than it was placed with.
fn updated_as(placed: Bounds, updated: Bounds) {
    let heights = Heights::new([4, 4], Border::Wrap, Texels::U16(vec![0; 16])).expect("a map");
    Placed::new(&heights, placed, 9).expect("whole steps").update(&heights, updated, &[0..1, 0..1]);
}

#[test]
#[should_panic(expected = "other bounds")]
fn a_map_is_updated_with_the_bounds_that_it_has() {
    updated_as(Bounds::CellMax, Bounds::Cells);
}

#[test]
#[should_panic(expected = "other bounds")]
fn cells_are_not_updated_as_wide_nodes() {
    updated_as(Bounds::Cells, Bounds::Wide);
}
