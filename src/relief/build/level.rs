//! One level of numbers, as a pass reads or draws it.

use wgpu::util::{DeviceExt as _, TextureDataOrder};

use crate::render::Gpu;

/// A mip of a layer of a texture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level<'t> {
    pub(super) texture: &'t wgpu::Texture,
    pub(super) mip: u32,
    pub(super) layer: u32,
    /// Its columns and rows; the mip may have more.
    pub(super) size: [u32; 2],
}

impl<'t> Level<'t> {
    /// A mip that is a level as it is.
    pub(super) fn whole(texture: &'t wgpu::Texture, mip: u32) -> Self {
        let size = texture.size().mip_level_size(mip, wgpu::TextureDimension::D2);
        Self { texture, mip, layer: 0, size: [size.width, size.height] }
    }

    pub(super) fn view(self) -> wgpu::TextureView {
        self.texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2),
            base_mip_level: self.mip,
            mip_level_count: Some(1),
            base_array_layer: self.layer,
            array_layer_count: Some(1),
            ..Default::default()
        })
    }
}

/// A texture that passes draw and read, and others may read as `usage` says.
pub(super) fn texture(
    gpu: &Gpu,
    format: wgpu::TextureFormat,
    size: [u32; 2],
    mip_level_count: u32,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    let usage = usage | wgpu::TextureUsages::COPY_SRC;
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        mip_level_count,
        usage: usage | DRAWN,
        ..descriptor(format, size, 1)
    })
}

/// One that only passes draw and read, of several layers.
pub(super) fn layers(device: &wgpu::Device, format: wgpu::TextureFormat, size: [u32; 2], count: u32) -> wgpu::Texture {
    device.create_texture(&descriptor(format, size, count))
}

/// One that passes only read, of these texels.
pub(super) fn filled(
    (device, queue): (&wgpu::Device, &wgpu::Queue),
    format: wgpu::TextureFormat,
    size: [u32; 2],
    texels: &[u8],
) -> wgpu::Texture {
    let usage = wgpu::TextureUsages::TEXTURE_BINDING;
    let descriptor = wgpu::TextureDescriptor { usage, ..descriptor(format, size, 1) };
    device.create_texture_with_data(queue, &descriptor, TextureDataOrder::LayerMajor, texels)
}

const DRAWN: wgpu::TextureUsages = wgpu::TextureUsages::TEXTURE_BINDING.union(wgpu::TextureUsages::RENDER_ATTACHMENT);

fn descriptor(format: wgpu::TextureFormat, [width, height]: [u32; 2], layers: u32) -> wgpu::TextureDescriptor<'static> {
    wgpu::TextureDescriptor {
        label: Some("relief"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: layers },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: DRAWN,
        view_formats: &[],
    }
}
