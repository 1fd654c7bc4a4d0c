//! Planes of a map as textures.

use terrane_shaderlib::relief::{Plane, Words};
use wgpu::util::{DeviceExt as _, TextureDataOrder};

use super::setup::DeviceRay;
use super::shader::COLUMNS;
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

/// Uploads rays, [`COLUMNS`] to a row: a processor reads a texel for eight of them at once, but words of a buffer one by one.
pub(super) fn rays(gpu: &Gpu, rays: &[DeviceRay]) -> wgpu::TextureView {
    let height = rays.len().div_ceil(COLUMNS);
    let mut bytes = bytemuck::cast_slice::<_, u8>(rays).to_vec();
    bytes.resize(height * COLUMNS * size_of::<DeviceRay>(), 0);
    let texels = COLUMNS * size_of::<DeviceRay>() / size_of::<[u32; 4]>();
    let descriptor = wgpu::TextureDescriptor {
        label: Some("rays"),
        size: wgpu::Extent3d { width: texels as u32, height: height as u32, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba32Uint,
        usage: wgpu::TextureUsages::STORAGE_BINDING,
        view_formats: &[],
    };
    let texture = gpu.device.create_texture_with_data(&gpu.queue, &descriptor, TextureDataOrder::LayerMajor, &bytes);
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
