//! Which parts of a level are drawn: the device says so itself, in a texture of one texel to a part.

use super::level::filled;
use super::passes::{bound, texture};

/// Cells along a part.
pub(super) const SIDE: u32 = 32;

/// The texels of a texture of parts: 1 where a part is drawn.
pub(super) const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R8Uint;

/// How passes read them.
#[derive(Clone, Debug)]
pub(super) struct Parts {
    pub(super) layout: wgpu::BindGroupLayout,
    device: wgpu::Device,
    /// Those of which all are drawn, of any level.
    pub(super) all: wgpu::BindGroup,
}

impl Parts {
    pub(super) fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("relief's parts"),
            entries: &[texture(0, wgpu::TextureSampleType::Uint, wgpu::TextureViewDimension::D2)],
        });
        // Behind the last part are those like it.
        let one = filled((device, queue), FORMAT, [1, 1], &[1]);
        Self { all: bind(device, &layout, &one), layout, device: device.clone() }
    }

    pub(super) fn bind(&self, parts: &wgpu::Texture) -> wgpu::BindGroup {
        bind(&self.device, &self.layout, parts)
    }
}

fn bind(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, parts: &wgpu::Texture) -> wgpu::BindGroup {
    let view = parts.create_view(&wgpu::TextureViewDescriptor::default());
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("relief's parts"),
        layout,
        entries: &[bound(0, &view)],
    })
}
