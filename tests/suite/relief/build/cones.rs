//! Cones that the device builds.

use terrane::relief::Built;
use terrane::render::Gpu;
use terrane_shaderlib::heightfield::adversary::{Depth, LANDS, Random, SIZES, map};
use terrane_shaderlib::heightfield::cones::{Cones, rings};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::relief::{Bounds, MapTexture, planes};

use super::changes::{changed, rectangles};
use super::{differences, equal};
use crate::relief::device;

const SQUARE: [MapTexture; 4] = [
    MapTexture::Bounds(Bounds::Cones(Cones::Robust)),
    MapTexture::Bounds(Bounds::Cells),
    MapTexture::Bounds(Bounds::Quadrants),
    MapTexture::Bounds(Bounds::Cones(Cones::Quadrant(2))),
];

const ROUND: [MapTexture; 2] =
    [MapTexture::Bounds(Bounds::Cones(Cones::Step)), MapTexture::Bounds(Bounds::Cones(Cones::Relaxed))];

/// Maps on which most of what cones see is farther away than squares grow texel by texel.
const FAR: [([u32; 2], Border); 4] = [
    ([192, 135], Border::Clamp),
    ([256, 64], Border::Wrap),
    // Nodes larger than the map is high.
    ([512, 1], Border::Wrap),
    ([2, 300], Border::Clamp),
];

/// Maps of every size, border and depth, each of the next land.
fn maps() -> impl Iterator<Item = (Heights, String)> {
    let small = SIZES.into_iter().flat_map(|size| [Border::Wrap, Border::Clamp].map(|border| (size, border)));
    let sizes = small.chain(FAR).flat_map(|one| [Depth::Eight, Depth::Sixteen].map(|depth| (one, depth)));
    sizes.enumerate().map(|(index, ((size, border), depth))| {
        let land = LANDS[index * 4 % LANDS.len()];
        let heights = map(land, size, border, depth, index as u64).expect("a map");
        (heights, format!("{land:?} {depth:?}"))
    })
}

#[test]
fn square_cones_are_those_of_the_host() {
    let Some(gpu) = device() else { return };
    for (heights, what) in maps() {
        let built = Built::new(&gpu, &heights, &SQUARE).expect("the device takes it");
        equal(&built, &SQUARE, &heights, &what);
    }
}

#[test]
fn distant_ground_is_seen_through_every_level() {
    let Some(gpu) = device() else { return };
    for (size, border) in FAR {
        assert!(rings(border == Border::Wrap, size).len() > 1, "{size:?} has no level but the first");
        for land in LANDS {
            let heights = map(land, size, border, Depth::Sixteen, 7).expect("a map");
            let built = Built::new(&gpu, &heights, &SQUARE[1..2]).expect("the device takes it");
            equal(&built, &SQUARE[1..2], &heights, &format!("{land:?}"));
        }
    }
}

fn updated(gpu: &Gpu, size: [u32; 2], border: Border, textures: &[MapTexture]) {
    let mut random = Random::new(u64::from(size[0]));
    let mut heights = map(LANDS[7], size, border, Depth::Sixteen, 5).expect("a map");
    let built = Built::new(gpu, &heights, textures).expect("the device takes it");
    for rectangle in rectangles(size, &mut random) {
        heights = changed(&heights, &rectangle, &mut random);
        built.update(&heights, &rectangle).expect("the device takes it");
        let what = format!("{rectangle:?}");
        if textures == ROUND {
            within_a_code(&built, &heights, &what);
        } else {
            equal(&built, textures, &heights, &what);
        }
    }
}

#[test]
fn a_changed_texel_changes_cones_wherever_it_is_seen() {
    let Some(gpu) = device() else { return };
    let small = [([16, 16], Border::Wrap), ([7, 5], Border::Clamp), ([15, 64], Border::Wrap)];
    small.into_iter().chain(FAR).for_each(|(size, border)| updated(&gpu, size, border, &SQUARE[..2]));
    small.into_iter().chain(FAR).for_each(|(size, border)| updated(&gpu, size, border, &ROUND));
}

/// What alone narrows all cones comes and goes, farther away than what is drawn again with it; coarse nodes of more than one part.
#[test]
fn a_peak_on_a_plain_comes_and_goes() {
    let Some(gpu) = device() else { return };
    let all: Vec<MapTexture> = SQUARE.into_iter().chain(ROUND).collect();
    let places = [
        (Border::Wrap, [256, 128], [200, 40], &all[..]),
        (Border::Clamp, [200, 100], [199, 99], &all),
        (Border::Wrap, [200, 100], [0, 0], &all),
        (Border::Wrap, [1024, 32], [0, 3], &SQUARE[1..2]),
        (Border::Clamp, [1000, 32], [900, 31], &SQUARE[1..2]),
    ];
    for (border, size, at, textures) in places {
        let map = |height: u16| {
            let mut values = vec![7; (size[0] * size[1]) as usize];
            values[(at[1] * size[0] + at[0]) as usize] = height;
            Heights::new(size, border, Texels::U16(values)).expect("a map")
        };
        let (flat, peak) = (map(7), map(50_000));
        for [before, after] in [[&flat, &peak], [&peak, &flat]] {
            let built = Built::new(&gpu, before, textures).expect("the device takes it");
            built.update(after, &at.map(|at| at..at + 1)).expect("the device takes it");
            let anew = Built::new(&gpu, after, textures).expect("the device takes it");
            let [built, anew] = [built, anew].map(|built| built.read().expect("the device answers"));
            for (texture, (built, anew)) in textures.iter().zip(built.iter().zip(&anew)) {
                assert!(built == anew, "{texture:?} of {size:?} {border:?}: {:?}", differences(built, anew));
            }
        }
    }
}

/// Whether round cones are those of the host or one code narrower, and no wider; how many are narrower, of how many.
#[track_caller]
fn within_a_code(built: &Built<'_>, heights: &Heights, what: &str) -> [usize; 2] {
    let device = built.read().expect("the device answers");
    let host = planes(heights, &ROUND).expect("whole steps");
    let mut count = [0; 2];
    for (texture, (device, host)) in ROUND.iter().zip(device.iter().zip(&host)) {
        assert_eq!((device.size, device.mips()), (host.size, host.mips()));
        let [width, height] = host.size;
        let rows = (0..host.mips()).flat_map(|mip| (0..height).map(move |y| (mip, y)));
        for (mip, at) in rows.flat_map(|(mip, y)| (0..width).map(move |x| (mip, [x, y]))) {
            let Some([tip, code, ..]) = host.texel(mip, at) else { continue };
            let found = device.texel(mip, at).expect("as large");
            let (size, border) = (heights.size(), heights.border());
            let narrower = code.wrapping_sub(found[1]);
            assert!(
                found[0] == tip && narrower <= 1,
                "{texture:?} of {size:?} {border:?} {what}: {mip} {at:?}: {found:?} for {tip} {code}"
            );
            count = [count[0] + narrower as usize, count[1] + 1];
        }
    }
    count
}

#[test]
fn round_cones_are_those_of_the_host_or_a_code_narrower() {
    let Some(gpu) = device() else { return };
    let mut counts = [0; 2];
    for (heights, what) in maps() {
        let built = Built::new(&gpu, &heights, &ROUND).expect("the device takes it");
        let [narrower, all] = within_a_code(&built, &heights, &what);
        counts = [counts[0] + narrower, counts[1] + all];
    }
    // A ratio that is a code's own becomes the next one, as those of whole distances and climbs of a power of two are.
    assert!(counts[0] * 4 < counts[1], "{counts:?} are narrower");
}
