//! Planes of a map as textures.

use terrane_shaderlib::relief::{Plane, Words};
use wgpu::util::{DeviceExt as _, TextureDataOrder};

use crate::render::Gpu;

/// Uploads a plane.
pub(super) fn texture(gpu: &Gpu, plane: &Plane) -> wgpu::TextureView {
    let [width, height] = plane.size;
    let (format, mips, bytes) = match &plane.words {
        Words::Rg16(mips) => (wgpu::TextureFormat::Rg16Uint, mips.len(), bytemuck::cast_slice(&mips.concat()).to_vec()),
        Words::R16(mips) => (wgpu::TextureFormat::R16Uint, mips.len(), bytemuck::cast_slice(&mips.concat()).to_vec()),
    };
    let descriptor = wgpu::TextureDescriptor {
        label: Some("relief"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: mips as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    };
    let texture = gpu.device.create_texture_with_data(&gpu.queue, &descriptor, TextureDataOrder::LayerMajor, &bytes);
    let dimension = Some(wgpu::TextureViewDimension::D2Array);
    texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() })
}
