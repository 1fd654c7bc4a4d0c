use super::super::ConeMap;
use super::super::part::standing;
use super::*;
use crate::heightfield::adversary::{Depth, LANDS, Land, Random, map};
use crate::heightfield::{Border, Texels};

const KINDS: [Cones; 7] = [
    Cones::Step,
    Cones::Relaxed,
    Cones::Robust,
    Cones::Quadrant(0),
    Cones::Quadrant(1),
    Cones::Quadrant(2),
    Cones::Quadrant(3),
];

/// The map with heights of its own or a plain one in a rectangle.
fn patched(heights: &Heights, texels: &[Range<u32>; 2], height: impl Fn(usize) -> u16) -> Heights {
    let Texels::U16(values) = heights.texels() else { panic!("a map of 16 bits") };
    let mut values = values.clone();
    for (x, y) in texels[1].clone().flat_map(|y| texels[0].clone().map(move |x| (x, y))) {
        let at = (y * heights.size()[0] + x) as usize;
        values[at] = height(at);
    }
    Heights::new(heights.size(), heights.border(), Texels::U16(values)).unwrap()
}

fn rectangle(size: [u32; 2], random: &mut Random) -> [Range<u32>; 2] {
    size.map(|side| {
        let most = random.one_of(&[1, 5, i64::from(side)]).min(i64::from(side));
        let length = random.between(1, most);
        let first = random.one_of(&[0, (i64::from(side) - length) / 2, i64::from(side) - length]);
        first as u32..(first + length) as u32
    })
}

/// A map of 16 bits as one of 8, or as one of floats, some of them below 0.
fn as_kind(heights: &Heights, kind: i64) -> Heights {
    let Texels::U16(values) = heights.texels() else { panic!("a map of 16 bits") };
    let texels = match kind {
        0 => Texels::U8(values.iter().map(|value| (value >> 8) as u8).collect()),
        1 => Texels::F32(values.iter().map(|value| f32::from(*value) * 0.037 - 500.0).collect()),
        _ => return heights.clone(),
    };
    Heights::new(heights.size(), heights.border(), texels).unwrap()
}

/// Rectangles that become heaps, hollows and rubble, one after the other.
fn update_again_and_again(mut heights: Heights, cones: Cones, random: &mut Random) {
    let (size, kind) = (heights.size(), random.between(0, 3));
    let mut updated = ConeMap::new(&as_kind(&heights, kind), cones, &|_, _| ());
    for _ in 0..4 {
        let texels = rectangle(size, random);
        let (form, seed) = (random.between(0, 2), random.bits());
        let after = patched(&heights, &texels, |at| match form {
            0 => 0,
            1 => u16::MAX,
            _ => (seed.wrapping_mul(at as u64 * 2 + 1) >> 48) as u16,
        });
        let maps = [&heights, &after].map(|map| as_kind(map, kind));
        let anew = ConeMap::new(&maps[1], cones, &|_, _| ());
        if updated.unit == anew.unit {
            every_other_cone_is_reached(maps.each_ref(), [&updated, &anew], &texels);
        }
        updated.update(&maps[0], &maps[1], &texels);
        heights = after;
        assert!(updated == anew, "{size:?} {:?} {cones:?} {texels:?} {form} {kind}", heights.border());
    }
}

/// Parts hide it: the nearest cones are found again with what has changed.
fn every_other_cone_is_reached(maps: [&Heights; 2], [before, after]: [&ConeMap; 2], texels: &[Range<u32>; 2]) {
    let stored = Stored { cones: before.cones, unit: before.unit };
    let change = Change::new(before.cones, maps, texels);
    let width = before.size[0] as usize;
    let is_reached = |[x, y]: [usize; 2], code| stored.is_as_steep(code, before.codes[y * width + x]);
    let [columns, rows] = standing(maps[1], before.cones);
    for at in (0..rows).flat_map(|y| (0..columns).map(move |x| [x, y])) {
        let index = at[1] * width + at[0];
        let is_other = before.codes[index] != after.codes[index];
        let reached = change.reaches(&stored, maps[1], at, &is_reached);
        assert!(reached || !is_other, "{:?} {texels:?}: {at:?} of {:?}", before.cones, before.size);
    }
}

#[test]
fn an_update_equals_cones_built_anew() {
    let mut random = Random::new(11);
    for size in [[1, 1], [2, 3], [17, 64], [150, 33], [65, 130], [300, 97]] {
        for (border, cones) in [Border::Wrap, Border::Clamp].iter().flat_map(|border| KINDS.map(|one| (*border, one))) {
            let land = LANDS[random.between(0, LANDS.len() as i64 - 1) as usize];
            update_again_and_again(map(land, size, border, Depth::Sixteen, random.bits()).unwrap(), cones, &mut random);
            // On a plain what has changed is all that there is, however far.
            let plain = Texels::U16(vec![0; (size[0] * size[1]) as usize]);
            update_again_and_again(Heights::new(size, border, plain).unwrap(), cones, &mut random);
        }
    }
}

#[test]
fn floats_whose_range_grows_get_another_unit() {
    let values: Vec<f32> = (0..128 * 16).map(|at| (at * 37 % 101) as f32).collect();
    let before = Heights::new([128, 16], Border::Wrap, Texels::F32(values.clone())).unwrap();
    for cones in KINDS {
        let mut after = values.clone();
        after[128 * 9 + 7] = 1e6;
        let after = Heights::new([128, 16], Border::Wrap, Texels::F32(after)).unwrap();
        let mut updated = ConeMap::new(&before, cones, &|_, _| ());
        let unit = updated.unit;
        updated.update(&before, &after, &[7..8, 9..10]);
        assert!(updated.unit > unit && updated == ConeMap::new(&after, cones, &|_, _| ()), "{cones:?}");
    }
}

/// From the lowest to the highest number it is farther than the highest number.
#[test]
fn floats_may_lie_as_far_apart_as_there_are_any() {
    let map = |height: f32| {
        let mut values = vec![-2e38; 160];
        (values[0], values[140]) = (2e38, height);
        Heights::new([160, 1], Border::Clamp, Texels::F32(values)).unwrap()
    };
    let (before, after) = (map(2e38), map(1e38));
    for cones in KINDS {
        let mut updated = ConeMap::new(&before, cones, &|_, _| ());
        updated.update(&before, &after, &[140..141, 0..1]);
        assert!(updated == ConeMap::new(&after, cones, &|_, _| ()), "{cones:?}");
    }
}

#[test]
fn what_is_not_reached_is_not_found_again() {
    let heights = map(Land::Noise, [512, 512], Border::Wrap, Depth::Sixteen, 3).unwrap();
    let texels = [200..203, 300..303];
    let after = patched(&heights, &texels, |_| 40_000);
    for cones in KINDS {
        let built = ConeMap::new(&heights, cones, &|_, _| ());
        let stored = Stored { cones, unit: built.unit };
        let is_reached = |[x, y]: [usize; 2], code| stored.is_as_steep(code, built.codes[y * 512 + x]);
        let changed = changed(&stored, (&heights, &after), std::slice::from_ref(&texels), &is_reached);
        let found = changed.iter().map(|(_, codes)| codes.len()).sum::<usize>();
        assert!((9..=4 * 64 * 64).contains(&found), "{cones:?}: {found} of {}", built.codes.len());
    }
}
