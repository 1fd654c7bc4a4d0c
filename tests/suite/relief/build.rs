//! Bounds and mips that the device builds, against those of the host.

use terrane::relief::Built;
use terrane::render::Gpu;
use terrane_shaderlib::heightfield::adversary::{Depth, LANDS, Random, SIZES, map};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::hosts;
use terrane_shaderlib::relief::{Bounds, Placed, Region, Words};

use super::device;
use crate::skip::Skip;
use crate::tint::{Module, Tint};

#[track_caller]
fn equal(built: &Built<'_>, heights: &Heights, what: &str) {
    let placed = Placed::new(heights, Bounds::CellMax, 1).expect("whole steps");
    let (mips, bounds) = built.read().expect("the device answers");
    let (size, border) = (heights.size(), heights.border());
    let Words::R16(host) = &placed.heights.words else { panic!("heights are 16 bits") };
    assert!(mips == *host, "heights of {size:?} {border:?} {what}: {:?}", differences(&mips.concat(), &host.concat()));
    let Words::R16(host) = &placed.bounds.words else { panic!("bounds of cells are 16 bits") };
    assert!(bounds == host[0], "bounds of {size:?} {border:?} {what}: {:?}", differences(&bounds, &host[0]));
}

/// The first texels in which device and host differ: index, device, host.
fn differences(device: &[u16], host: &[u16]) -> Vec<(usize, u16, u16)> {
    let pairs = device.iter().zip(host).enumerate().map(|(at, (device, host))| (at, *device, *host));
    pairs.filter(|(_, device, host)| device != host).take(8).collect()
}

/// A long map, and one that is filled up on one axis alone, besides the adversary's.
const SIDES: [[u32; 2]; 2] = [[256, 2], [64, 65]];

fn kinds() -> impl Iterator<Item = ([u32; 2], Border, Depth)> {
    let sizes = SIZES.into_iter().chain(SIDES);
    let borders = sizes.flat_map(|size| [Border::Wrap, Border::Clamp].map(|border| (size, border)));
    borders.flat_map(|(size, border)| [Depth::Eight, Depth::Sixteen].map(|depth| (size, border, depth)))
}

#[test]
fn the_device_builds_what_the_host_builds() {
    let Some(gpu) = device() else { return };
    for (index, (size, border, depth)) in kinds().enumerate() {
        let heights = map(LANDS[index * 4 % LANDS.len()], size, border, depth, index as u64).expect("a map");
        let built = Built::new(&gpu, &heights).expect("the device takes it");
        equal(&built, &heights, &format!("{depth:?}"));
    }
}

/// Single texels at corners, columns and rows along borders, something inside.
fn rectangles([width, height]: [u32; 2]) -> [Region; 7] {
    [
        [0..1, 0..1],
        [width - 1..width, height - 1..height],
        [0..1, height - 1..height],
        [width - 1..width, 0..height],
        [0..width, 0..1],
        [width / 3..width / 3 + 1, height / 2..(height / 2 + 3).min(height)],
        [0..0, 0..height],
    ]
}

/// The map with other heights in a rectangle.
fn changed(heights: &Heights, [columns, rows]: &Region, random: &mut Random) -> Heights {
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
        Texels::F32(_) => panic!("the adversary makes whole steps"),
    };
    Heights::new(heights.size(), heights.border(), texels).expect("the size of a map")
}

fn updated(gpu: &Gpu, size: [u32; 2], border: Border, depth: Depth) {
    let mut random = Random::new(u64::from(size[0]));
    let land = LANDS[random.between(0, LANDS.len() as i64 - 1) as usize];
    let mut heights = map(land, size, border, depth, random.bits()).expect("a map");
    let built = Built::new(gpu, &heights).expect("the device takes it");
    for rectangle in rectangles(size) {
        heights = changed(&heights, &rectangle, &mut random);
        built.update(&heights, &rectangle).expect("the device takes it");
        equal(&built, &heights, &format!("{depth:?}, {land:?}, {rectangle:?}"));
    }
}

#[test]
fn a_part_brought_up_to_date_equals_the_whole_built_anew() {
    let Some(gpu) = device() else { return };
    kinds().for_each(|(size, border, depth)| updated(&gpu, size, border, depth));
}

#[test]
fn a_map_of_floats_is_refused() {
    let Some(gpu) = device() else { return };
    let heights = Heights::new([1, 1], Border::Wrap, Texels::F32(vec![0.5])).expect("a map");
    let error = Built::new(&gpu, &heights).expect_err("floats have no steps").to_string();
    assert!(error.contains("quantise"), "{error}");
}

#[test]
fn tint_accepts_the_passes() {
    let Ok(mut tint) = Tint::start().map_err(Skip::report) else { return };
    let module = Module { name: "build".into(), wgsl: hosts::join(hosts::WGPU_RELIEF_BUILD), pipelines: Vec::new() };
    for report in tint.validate(&[module]) {
        assert!(report.errors().is_empty(), "{}", report.errors());
    }
}
