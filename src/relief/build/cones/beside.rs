//! What passes over cones read beside their tips.

use bytemuck::{Pod, Zeroable};
use terrane_shaderlib::heightfield::cones::{NEAR, Ring};
use wgpu::util::{BufferInitDescriptor, DeviceExt as _};

use crate::relief::build::level::Level;
use crate::relief::build::passes::{bound, texture, uniform};
use crate::render::Gpu;

/// The second group of `hosts/relief/build_cones.wgsl`.
pub(super) struct Beside<'a> {
    /// The table of a level, all of its layers.
    pub(super) table: &'a wgpu::Texture,
    /// The slopes to what is nearer.
    pub(super) slopes: Level<'a>,
    /// The rings of a level.
    pub(super) rings: (usize, &'a [Ring]),
}

/// `BuildRings` there.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct DeviceRings {
    rings: [DeviceRing; NEAR],
    count: i32,
    level: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Default, Pod, Zeroable)]
struct DeviceRing {
    reach: i32,
    layer: i32,
    share: f32,
    middle: f32,
}

impl Beside<'_> {
    pub(super) fn layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
        use wgpu::{TextureSampleType as Sample, TextureViewDimension as Dimension};
        gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("relief's cones"),
            entries: &[
                texture(0, Sample::Uint, Dimension::D2Array),
                texture(1, Sample::Float { filterable: false }, Dimension::D2),
                uniform(2),
            ],
        })
    }

    pub(super) fn bind(&self, device: &wgpu::Device, layout: &wgpu::BindGroupLayout) -> wgpu::BindGroup {
        let rings = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("relief's rings"),
            contents: bytemuck::bytes_of(&device_rings(self.rings)),
            usage: wgpu::BufferUsages::UNIFORM,
        });
        let table = self.table.create_view(&wgpu::TextureViewDescriptor::default());
        let views = [&table, &self.slopes.view()];
        let textures = views.into_iter().zip(0..);
        let textures = textures.map(|(view, binding)| bound(binding, view));
        let rings = wgpu::BindGroupEntry { binding: 2, resource: rings.as_entire_binding() };
        let entries: Vec<_> = textures.chain([rings]).collect();
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("relief's cones"),
            layout,
            entries: &entries,
        })
    }
}

fn device_rings((level, rings): (usize, &[Ring])) -> DeviceRings {
    let mut all = [DeviceRing::default(); NEAR];
    for (one, Ring { reach, share, middle }) in all.iter_mut().zip(rings) {
        let layer = (reach + 1).ilog2() as i32;
        *one = DeviceRing { reach: *reach as i32, layer, share: *share, middle: *middle };
    }
    DeviceRings { rings: all, count: rings.len() as i32, level: level as u32 }
}
