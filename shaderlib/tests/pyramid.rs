//! Pyramids against their definition, for every size, border and kind of map.

use proptest::prelude::*;
use terrane_shaderlib::heightfield::pyramid::{Bound, Pyramid, Wide};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};

/// A map of up to 70 texels a side, with values at both ends more often than chance has it.
fn map() -> impl Strategy<Value = Heights> {
    let value = prop_oneof![3 => any::<u16>(), 1 => Just(0), 1 => Just(u16::MAX), 1 => Just(256)];
    (1..70_u32, 1..70_u32, prop::bool::ANY, 0..3_u8).prop_flat_map(move |(width, height, wrap, kind)| {
        prop::collection::vec(value.clone(), (width * height) as usize).prop_map(move |values| {
            let texels = match kind {
                0 => Texels::U8(values.iter().map(|value| (value >> 8) as u8).collect()),
                1 => Texels::U16(values),
                _ => Texels::F32(values.iter().map(|value| f32::from(*value) * 0.37 - 5000.0).collect()),
            };
            let border = if wrap { Border::Wrap } else { Border::Clamp };
            Heights::new([width, height], border, texels).expect("a map")
        })
    })
}

/// The bound of a node by its definition: over all cells or texels that it covers.
fn expected(heights: &Heights, bound: Bound, level: usize, x: u32, y: u32) -> f64 {
    let count = if bound == Bound::TexelMax { heights.size() } else { heights.cells() };
    let side = 1_u32 << level;
    let covered = |at: u32, count: u32| at * side..((at + 1) * side).min(count);
    let cells = covered(y, count[1]).flat_map(|y| covered(x, count[0]).map(move |x| (i64::from(x), i64::from(y))));
    let heights = cells.flat_map(|(x, y)| match bound {
        Bound::TexelMax => vec![heights.height(x, y)],
        Bound::CellMax | Bound::CellMin => heights.corners(x, y).to_vec(),
    });
    if bound == Bound::CellMin { heights.fold(f64::MAX, f64::min) } else { heights.fold(f64::MIN, f64::max) }
}

fn check(heights: &Heights, pyramid: &Pyramid, bound: Bound) {
    let mut size = if bound == Bound::TexelMax { heights.size() } else { heights.cells() };
    for level in 0.. {
        for y in 0..size[1] {
            for x in 0..size[0] {
                assert_eq!(pyramid.at(level, x, y), expected(heights, bound, level, x, y), "{bound:?} {level} {x} {y}");
            }
        }
        if size == [1, 1] {
            return;
        }
        size = size.map(|side| side.div_ceil(2));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_node_is_the_extreme_of_what_it_covers(heights in map()) {
        for bound in [Bound::TexelMax, Bound::CellMax, Bound::CellMin] {
            check(&heights, &Pyramid::new(&heights, bound), bound);
        }
    }

    #[test]
    fn an_update_equals_a_rebuild(before in map(), seed in any::<u64>(), corner in (0.0..1.0, 0.0..1.0), share in (0.0..1.0, 0.0..1.0)) {
        let size = before.size();
        let first = [corner.0, corner.1].map(f64::from);
        let first: [u32; 2] = [0, 1].map(|i| (first[i] * f64::from(size[i])) as u32);
        let end: [u32; 2] = [0, 1].map(|i| first[i] + 1 + ([share.0, share.1][i] * f64::from(size[i] - first[i] - 1)) as u32);
        let rectangle = [first[0]..end[0], first[1]..end[1]];
        let after = changed(&before, &rectangle, seed);
        for bound in [Bound::TexelMax, Bound::CellMax, Bound::CellMin] {
            let mut pyramid = Pyramid::new(&before, bound);
            pyramid.update(&after, rectangle.clone());
            prop_assert_eq!(&pyramid, &Pyramid::new(&after, bound));
            if let (Bound::CellMax, Ok(mut wide)) = (bound, Wide::new(&before)) {
                wide.update(&pyramid, &after, &rectangle);
                prop_assert_eq!(wide, Wide::over(&pyramid).expect("steps"));
            }
        }
    }

    #[test]
    fn wide_bounds_are_above_by_a_64th_of_what_a_node_spans_at_most(heights in map()) {
        let Ok(wide) = Wide::new(&heights) else { return Ok(()) };
        let mut cells = heights.cells();
        for level in 1..=wide.levels.len() {
            let highest = |x, y| expected(&heights, Bound::CellMax, 2 * level - 2, x, y);
            for (x, y) in (0..cells[1]).flat_map(|y| (0..cells[0]).map(move |x| (x, y))) {
                let [columns, rows] = [(x, 0), (y, 1)].map(|(at, axis)| at / 4 * 4..(at / 4 * 4 + 4).min(cells[axis]));
                let all = rows.flat_map(|y| columns.clone().map(move |x| (x, y))).map(|(x, y)| highest(x, y));
                let (low, high) = all.fold((f64::MAX, 0.0), |(low, high), one| (f64::min(low, one), f64::max(high, one)));
                let span = high - low + f64::from(1_u32 << wide.unit);
                let above = f64::from(wide.bound(level, x, y)) - highest(x, y);
                prop_assert!((0.0..=(span / 64.0).max(1.0)).contains(&above), "{} of {}", above, span);
            }
            cells = cells.map(|side| side.div_ceil(4));
        }
    }
}

/// The map with other heights in a rectangle.
fn changed(heights: &Heights, rectangle: &[std::ops::Range<u32>; 2], seed: u64) -> Heights {
    let width = heights.size()[0];
    let inside = |index: usize| {
        let (x, y) = (index as u32 % width, index as u32 / width);
        rectangle[0].contains(&x) && rectangle[1].contains(&y)
    };
    let new = |index: usize| (seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(index as u32 % 64) >> 40) as u32;
    let texels = match heights.texels() {
        Texels::U8(values) => Texels::U8(replaced(values, inside, |index| new(index) as u8)),
        Texels::U16(values) => Texels::U16(replaced(values, inside, |index| new(index) as u16)),
        Texels::F32(values) => Texels::F32(replaced(values, inside, |index| new(index) as f32)),
    };
    Heights::new(heights.size(), heights.border(), texels).expect("a map")
}

fn replaced<T: Copy>(values: &[T], inside: impl Fn(usize) -> bool, new: impl Fn(usize) -> T) -> Vec<T> {
    values.iter().enumerate().map(|(index, value)| if inside(index) { new(index) } else { *value }).collect()
}
