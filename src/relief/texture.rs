//! Planes of maps as textures.

use terrane_shaderlib::relief::{Plane, Words};
use wgpu::util::{DeviceExt as _, TextureDataOrder};

use super::setup::DeviceRay;
use super::shader::COLUMNS;
use crate::render::Gpu;

/// Uploads planes of one size and kind, a layer each.
pub(crate) fn textures(gpu: &Gpu, planes: &[&Plane]) -> wgpu::TextureView {
    let first = planes[0];
    let (format, mips) = match &first.words {
        Words::R16(mips) => (wgpu::TextureFormat::R16Uint, mips.len()),
        Words::Rg16(mips) => (wgpu::TextureFormat::Rg16Uint, mips.len()),
        Words::R32(_) => (wgpu::TextureFormat::R32Uint, 1),
        Words::Rg32(_) => (wgpu::TextureFormat::Rg32Uint, 1),
        Words::Rgba32(_) => (wgpu::TextureFormat::Rgba32Uint, 1),
    };
    let usage = match &first.words {
        Words::R16(_) | Words::Rg16(_) | Words::Rgba32(_) => wgpu::TextureUsages::TEXTURE_BINDING,
        Words::R32(_) | Words::Rg32(_) => wgpu::TextureUsages::STORAGE_BINDING,
    };
    let [width, height] = first.size;
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("relief"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: planes.len() as u32 },
        mip_level_count: mips as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: usage | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (layer, plane) in planes.iter().enumerate() {
        write(gpu, &texture, layer as u32, plane);
    }
    let dimension = Some(wgpu::TextureViewDimension::D2Array);
    texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() })
}

fn write(gpu: &Gpu, texture: &wgpu::Texture, layer: u32, plane: &Plane) {
    let mips: Vec<(&[u8], u32)> = match &plane.words {
        Words::R16(mips) => mips.iter().map(|mip| (bytemuck::cast_slice(mip), 2)).collect(),
        Words::Rg16(mips) => mips.iter().map(|mip| (bytemuck::cast_slice(mip), 4)).collect(),
        Words::R32(words) => vec![(bytemuck::cast_slice(words), 4)],
        Words::Rg32(words) => vec![(bytemuck::cast_slice(words), 8)],
        Words::Rgba32(words) => vec![(bytemuck::cast_slice(words), 16)],
    };
    for (level, (bytes, texel)) in mips.into_iter().enumerate() {
        let [width, height] = plane.size.map(|side| (side >> level).max(1));
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo {
                texture,
                mip_level: level as u32,
                origin: wgpu::Origin3d { x: 0, y: 0, z: layer },
                aspect: wgpu::TextureAspect::All,
            },
            bytes,
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(width * texel), rows_per_image: Some(height) },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
    }
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
