//! Bounds and mips that the device builds, against those of the host.

mod changes;
mod cones;
mod pyramids;

use terrane::relief::Built;
use terrane::render::Gpu;
use terrane_shaderlib::heightfield::adversary::{Depth, LANDS, Random, SIZES, map};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::hosts;
use terrane_shaderlib::relief::{Bounds, MapTexture, Plane, planes};

use self::changes::{changed, rectangles};
use super::device;
use crate::skip::Skip;
use crate::tint::{Module, Tint};

const ALL: [MapTexture; 7] = [
    MapTexture::Heights,
    MapTexture::Patches,
    MapTexture::Bounds(Bounds::None),
    MapTexture::Bounds(Bounds::CellMax),
    MapTexture::Bounds(Bounds::TexelMax),
    MapTexture::Bounds(Bounds::Patches),
    MapTexture::Bounds(Bounds::Wide),
];

#[track_caller]
fn equal(built: &Built<'_>, textures: &[MapTexture], heights: &Heights, what: &str) {
    let (size, border) = (heights.size(), heights.border());
    let device = built.read().expect("the device answers");
    let host = planes(heights, textures).expect("whole steps");
    assert_eq!(device.len(), host.len());
    for (texture, (device, host)) in textures.iter().zip(device.iter().zip(&host)) {
        assert_eq!((device.size, device.mips()), (host.size, host.mips()), "{texture:?} of {size:?} {border:?} {what}");
        let differences = || differences(device, host);
        assert!(device == host, "{texture:?} of {size:?} {border:?} {what}: {:?}", differences());
    }
}

/// The first texels in which device and host differ: mip, column and row, and of each what a shader loads there.
fn differences(device: &Plane, host: &Plane) -> Vec<String> {
    let [width, height] = host.size;
    let rows = (0..host.mips()).flat_map(|mip| (0..height).map(move |y| (mip, y)));
    let texels = rows.flat_map(|(mip, y)| (0..width).map(move |x| (mip, [x, y])));
    let differ = texels.filter(|(mip, at)| device.texel(*mip, *at) != host.texel(*mip, *at)).take(8);
    differ.map(|(mip, at)| format!("{mip} {at:?}: {:?} {:?}", device.texel(mip, at), host.texel(mip, at))).collect()
}

/// A long map, one that is filled up on one axis alone, and one whose wide nodes take several rows, besides the adversary's.
const SIDES: [[u32; 2]; 3] = [[256, 2], [64, 65], [256, 128]];

fn sizes() -> impl Iterator<Item = ([u32; 2], Border)> {
    let sizes = SIZES.into_iter().chain(SIDES);
    sizes.flat_map(|size| [Border::Wrap, Border::Clamp].map(|border| (size, border)))
}

fn kinds() -> impl Iterator<Item = ([u32; 2], Border, Depth)> {
    sizes().flat_map(|(size, border)| [Depth::Eight, Depth::Sixteen].map(|depth| (size, border, depth)))
}

#[test]
fn the_device_builds_what_the_host_builds() {
    let Some(gpu) = device() else { return };
    for (index, (size, border, depth)) in kinds().enumerate() {
        let heights = map(LANDS[index * 4 % LANDS.len()], size, border, depth, index as u64).expect("a map");
        let built = Built::new(&gpu, &heights, &ALL).expect("the device takes it");
        equal(&built, &ALL, &heights, &format!("{depth:?}"));
    }
}

#[test]
fn each_texture_is_built_alone_and_in_any_order() {
    let Some(gpu) = device() else { return };
    let heights = map(LANDS[6], [64, 16], Border::Wrap, Depth::Sixteen, 3).expect("a map");
    let reversed: Vec<MapTexture> = ALL.into_iter().rev().collect();
    for textures in ALL.chunks(1).chain([&reversed[..], &[]]) {
        let built = Built::new(&gpu, &heights, textures).expect("the device takes it");
        equal(&built, textures, &heights, "alone or reversed");
        for (texture, built) in textures.iter().zip(built.textures()) {
            let stored = built.usage().contains(wgpu::TextureUsages::STORAGE_BINDING);
            assert_eq!(stored, texture.is_storage(), "{texture:?} is bound as shaders read it");
        }
    }
}

fn updated(gpu: &Gpu, size: [u32; 2], border: Border, depth: Depth) {
    let mut random = Random::new(u64::from(size[0]));
    let land = LANDS[random.between(0, LANDS.len() as i64 - 1) as usize];
    let mut heights = map(land, size, border, depth, random.bits()).expect("a map");
    let built = Built::new(gpu, &heights, &ALL).expect("the device takes it");
    for rectangle in rectangles(size, &mut random) {
        heights = changed(&heights, &rectangle, &mut random);
        built.update(&heights, &rectangle).expect("the device takes it");
        equal(&built, &ALL, &heights, &format!("{depth:?}, {land:?}, {rectangle:?}"));
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
    let error = Built::new(&gpu, &heights, &ALL).expect_err("it is refused").to_string();
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
