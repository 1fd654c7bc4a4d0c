//! Texels back from the device.

use bytemuck::Pod;
use terrane_shaderlib::relief::{Plane, Words};

use super::level::Level;
use crate::render::{Gpu, RenderError};

/// The texels of a level, row by row; one is a `T`.
pub(super) fn texels<T: Pod>(gpu: &Gpu, level: Level<'_>) -> Result<Vec<T>, RenderError> {
    let [width, height] = level.size;
    let row = width * size_of::<T>() as u32;
    let stride = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.checked("relief's texels", || {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("relief's texels"),
            size: u64::from(stride) * u64::from(height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        })
    })?;
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut source = level.texture.as_image_copy();
    source.mip_level = level.mip;
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride), rows_per_image: None };
    let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    encoder.copy_texture_to_buffer(source, wgpu::TexelCopyBufferInfo { buffer: &buffer, layout }, size);
    gpu.queue.submit([encoder.finish()]);
    let bytes = gpu.read(&buffer)?;
    let rows = bytes.chunks_exact(stride as usize).map(|texels| &texels[..row as usize]);
    Ok(rows.flat_map(bytemuck::pod_collect_to_vec::<u8, T>).collect())
}

/// A whole texture.
pub(super) fn plane(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Plane, RenderError> {
    let first = Level::whole(texture, 0);
    let words = match texture.format() {
        wgpu::TextureFormat::R16Uint => Words::R16(mips(gpu, texture)?),
        wgpu::TextureFormat::R32Uint => Words::R32(texels(gpu, first)?),
        wgpu::TextureFormat::Rg32Uint => Words::Rg32(mips(gpu, texture)?),
        wgpu::TextureFormat::Rgba32Uint => Words::Rgba32(texels(gpu, first)?),
        other => unreachable!("{other:?} is the format of no texture that is drawn"),
    };
    Ok(Plane { size: first.size, words })
}

fn mips<T: Pod>(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<Vec<T>>, RenderError> {
    (0..texture.mip_level_count()).map(|mip| texels(gpu, Level::whole(texture, mip))).collect()
}
