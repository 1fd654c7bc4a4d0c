//! Pyramids that the device builds, level by level.

use terrane::relief::BuiltPyramid;
use terrane::render::Gpu;
use terrane_shaderlib::heightfield::adversary::{Depth, LANDS, Random, map};
use terrane_shaderlib::heightfield::pyramid::{Bound, Level, Levels, Pyramid};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};

use super::changes::{changed, float, rectangles};
use super::sizes;
use crate::relief::device;

const BOUNDS: [Bound; 3] = [Bound::TexelMax, Bound::CellMax, Bound::CellMin];

/// A map of whole steps of either depth, and one of floats.
fn maps(size: [u32; 2], border: Border, random: &mut Random) -> [Heights; 3] {
    let land = LANDS[random.between(0, LANDS.len() as i64 - 1) as usize];
    let [eight, sixteen] =
        [Depth::Eight, Depth::Sixteen].map(|depth| map(land, size, border, depth, random.bits()).expect("a map"));
    let floats = Texels::F32((0..size[0] * size[1]).map(|_| float(random)).collect());
    [eight, sixteen, Heights::new(size, border, floats).expect("a map")]
}

/// Sizes and words of all levels. Floats that are equal may differ in their bits.
fn words(levels: &Levels) -> Vec<([u32; 2], Vec<u32>)> {
    fn of<T: Copy>(levels: &[Level<T>], word: impl Fn(T) -> u32) -> Vec<([u32; 2], Vec<u32>)> {
        levels.iter().map(|level| (level.size, level.values.iter().map(|value| word(*value)).collect())).collect()
    }
    match levels {
        Levels::U8(levels) => of(levels, u32::from),
        Levels::U16(levels) => of(levels, u32::from),
        Levels::F32(levels) => of(levels, f32::to_bits),
    }
}

#[track_caller]
fn equal(built: &BuiltPyramid<'_>, heights: &Heights, bound: Bound, what: &str) {
    let [device, host] =
        [built.read().expect("the device answers"), Pyramid::new(heights, bound).into_levels()].map(|all| words(&all));
    assert_eq!(device.len(), host.len());
    for (level, (device, host)) in device.iter().zip(&host).enumerate() {
        assert_eq!(device.0, host.0, "level {level}");
        let pairs = device.1.iter().zip(&host.1).enumerate().filter(|(_, (device, host))| device != host);
        let differences: Vec<_> = pairs.take(8).collect();
        let (size, border) = (heights.size(), heights.border());
        assert!(differences.is_empty(), "{bound:?} of {size:?} {border:?} {what}, level {level}: {differences:?}");
    }
}

fn updated(gpu: &Gpu, mut heights: Heights, bound: Bound, random: &mut Random) {
    let built = BuiltPyramid::new(gpu, &heights, bound).expect("the device takes it");
    equal(&built, &heights, bound, "built");
    for rectangle in rectangles(heights.size(), random) {
        heights = changed(&heights, &rectangle, random);
        built.update(&heights, &rectangle).expect("the device takes it");
        equal(&built, &heights, bound, &format!("{rectangle:?}"));
    }
}

#[test]
fn the_device_builds_and_updates_the_levels_of_the_host() {
    let Some(gpu) = device() else { return };
    let mut random = Random::new(1);
    for (size, border) in sizes() {
        for heights in maps(size, border, &mut random) {
            BOUNDS.into_iter().for_each(|bound| updated(&gpu, heights.clone(), bound, &mut random));
        }
    }
}
