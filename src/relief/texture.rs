//! Planes of maps as textures.

use terrane_shaderlib::relief::{Plane, Words};

use crate::render::Gpu;

/// Uploads planes of one size and kind, a layer each.
pub(crate) fn textures(gpu: &Gpu, planes: &[&Plane]) -> wgpu::TextureView {
    let first = planes[0];
    let (format, mips) = match &first.words {
        Words::R16(mips) => (wgpu::TextureFormat::R16Uint, mips.len()),
        Words::Rg16(mips) => (wgpu::TextureFormat::Rg16Uint, mips.len()),
    };
    let [width, height] = first.size;
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("relief"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: planes.len() as u32 },
        mip_level_count: mips as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
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
