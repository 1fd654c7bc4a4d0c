//! Which cones the device draws again after a change.

use terrane_shaderlib::heightfield::adversary::{Depth, Land, Random, map};
use terrane_shaderlib::heightfield::cones::Cones;
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::relief::{Bounds, MapTexture, Region};

use crate::relief::Built;
use crate::render::{Gpu, Selection};

/// Cones as no map has them: a texel with the steepest, and one with the gentlest, over tips of no height.
const KINDS: [(MapTexture, [f64; 2], [f64; 2]); 3] = [
    (MapTexture::Bounds(Bounds::Cones(Cones::Robust)), [0.0, 65535.0], [0.0, 0.0]),
    (MapTexture::Bounds(Bounds::Quadrants), [16_777_215.0, 16_777_215.0], [0.0, 0.0]),
    (MapTexture::Bounds(Bounds::Cones(Cones::Step)), [0.0, 0.0], [0.0, 65535.0]),
];

const SIDE: u32 = 128;

/// Columns, and rows, of the texels that change: from the first to what is behind the last.
const TEXELS: [u32; 2] = [5, 12];

/// Puts one value in all texels of all mips.
fn fill(gpu: &Gpu, texture: &wgpu::Texture, [r, g]: [f64; 2]) {
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    for mip in 0..texture.mip_level_count() {
        let mip = wgpu::TextureViewDescriptor { base_mip_level: mip, mip_level_count: Some(1), ..Default::default() };
        let view = texture.create_view(&mip);
        let color = wgpu::Color { r, g, b: 0.0, a: 0.0 };
        let ops = wgpu::Operations { load: wgpu::LoadOp::Clear(color), store: wgpu::StoreOp::Store };
        let target = wgpu::RenderPassColorAttachment { view: &view, depth_slice: None, resolve_target: None, ops };
        let pass = wgpu::RenderPassDescriptor { color_attachments: &[Some(target)], ..Default::default() };
        drop(encoder.begin_render_pass(&pass));
    }
    gpu.queue.submit([encoder.finish()]);
}

/// The map with other heights in a rectangle.
fn changed(heights: &Heights, [columns, rows]: &Region) -> Heights {
    let Texels::U16(mut values) = heights.texels().clone() else { panic!("a map of 16 bits") };
    let mut random = Random::new(1);
    for (x, y) in rows.clone().flat_map(|y| columns.clone().map(move |x| (x, y))) {
        values[(y * SIDE + x) as usize] = random.bits() as u16;
    }
    Heights::new(heights.size(), heights.border(), Texels::U16(values)).expect("the size of a map")
}

/// What the device has of the first mip after a change of a map whose cones were all replaced: for each texel whether it is the one
/// that they were replaced by, and whether it is that of a map built anew.
fn after_a_change(gpu: &Gpu, texture: MapTexture, texel: [f64; 2]) -> Vec<([u32; 2], bool, bool)> {
    let mut heights = map(Land::Noise, [SIDE; 2], Border::Wrap, Depth::Sixteen, 3).expect("a map");
    let built = Built::new(gpu, &heights, &[texture]).expect("the device takes it");
    built.textures().for_each(|texture| fill(gpu, texture, texel));
    let rectangle = [TEXELS[0]..TEXELS[1], TEXELS[0]..TEXELS[1]];
    heights = changed(&heights, &rectangle);
    built.update(&heights, &rectangle).expect("the device takes it");
    let device = &built.read().expect("the device answers")[0];
    let anew =
        &Built::new(gpu, &heights, &[texture]).expect("the device takes it").read().expect("the device answers")[0];
    let places = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| [x, y]));
    let told = places.map(|at| {
        let found = device.texel(0, at).expect("inside");
        (at, found[..2] == texel.map(|word| word as u32), device.texel(0, at) == anew.texel(0, at))
    });
    told.collect()
}

#[test]
fn cones_that_are_steeper_than_a_change_stay() {
    let Ok(gpu) = Gpu::new(&Selection::Best) else { return println!("skipped: no device") };
    for (texture, steepest, _) in KINDS {
        for (at, is_as_it_was, is_new) in after_a_change(&gpu, texture, steepest) {
            let is_beside = at.iter().all(|at| (TEXELS[0] - 1..TEXELS[1]).contains(at));
            assert!(!is_beside || is_new, "{texture:?}: {at:?} is not brought up to date");
            // Parts end at multiples of 32, and the change is in the first one.
            let is_far = at.iter().any(|at| *at >= 32);
            assert!(!is_far || is_as_it_was, "{texture:?}: {at:?} is drawn again");
        }
    }
}

#[test]
fn cones_that_are_gentler_than_a_change_are_drawn_again_wherever_they_are() {
    let Ok(gpu) = Gpu::new(&Selection::Best) else { return println!("skipped: no device") };
    for (texture, _, gentlest) in KINDS {
        for (at, _, is_new) in after_a_change(&gpu, texture, gentlest) {
            assert!(is_new, "{texture:?}: {at:?} is not brought up to date");
        }
    }
}
