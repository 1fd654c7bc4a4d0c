//! Planes of a map as textures.

use terrane_shaderlib::relief::{Plane, Words};
use wgpu::util::{DeviceExt as _, TextureDataOrder};

use crate::render::Gpu;

/// Uploads a plane.
pub(super) fn texture(gpu: &Gpu, plane: &Plane) -> wgpu::TextureView {
    let [width, height] = plane.size;
    let (format, mips, bytes) = match &plane.words {
        Words::R16(mips) => (wgpu::TextureFormat::R16Uint, mips.len(), bytemuck::cast_slice(&mips.concat()).to_vec()),
        Words::R32(words) => (wgpu::TextureFormat::R32Uint, 1, bytemuck::cast_slice(words).to_vec()),
        Words::Rg32(words) => (wgpu::TextureFormat::Rg32Uint, 1, bytemuck::cast_slice(words).to_vec()),
        Words::Rgba32(words) => (wgpu::TextureFormat::Rgba32Uint, 1, bytemuck::cast_slice(words).to_vec()),
    };
    let usage = match &plane.words {
        Words::R16(_) | Words::Rgba32(_) => wgpu::TextureUsages::TEXTURE_BINDING,
        Words::R32(_) | Words::Rg32(_) => wgpu::TextureUsages::STORAGE_BINDING,
    };
    let descriptor = wgpu::TextureDescriptor {
        label: Some("relief"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: mips as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    };
    let texture = gpu.device.create_texture_with_data(&gpu.queue, &descriptor, TextureDataOrder::LayerMajor, &bytes);
    let dimension = Some(wgpu::TextureViewDimension::D2Array);
    texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() })
}
