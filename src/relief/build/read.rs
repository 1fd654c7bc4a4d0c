//! Texels back from the device.

use bytemuck::Pod;
use terrane_shaderlib::relief::{Plane, Words};

use super::level::Level;
use crate::render::{Gpu, RenderError};

/// The texels of levels, row by row; one is a `T`.
pub(super) fn texels<T: Pod>(gpu: &Gpu, levels: &[Level<'_>]) -> Result<Vec<Vec<T>>, RenderError> {
    let row = |level: &Level<'_>| level.size[0] as usize * size_of::<T>();
    let stride = |level: &Level<'_>| row(level).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize);
    let bytes = |level: &Level<'_>| stride(level) * level.size[1] as usize;
    let buffer = gpu.checked("relief's texels", || {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("relief's texels"),
            size: levels.iter().map(bytes).sum::<usize>() as u64,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        })
    })?;
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut end = 0;
    for level in levels {
        copy(&mut encoder, *level, &buffer, end, stride(level));
        end += bytes(level);
    }
    gpu.queue.submit([encoder.finish()]);
    let mut rest = &gpu.read(&buffer)?[..];
    let texels = levels.iter().map(|level| {
        let (first, behind) = rest.split_at(bytes(level));
        rest = behind;
        let rows = first.chunks_exact(stride(level)).map(|texels| &texels[..row(level)]);
        rows.flat_map(bytemuck::pod_collect_to_vec::<u8, T>).collect()
    });
    Ok(texels.collect())
}

fn copy(encoder: &mut wgpu::CommandEncoder, level: Level<'_>, buffer: &wgpu::Buffer, offset: usize, stride: usize) {
    let mut source = level.texture.as_image_copy();
    source.mip_level = level.mip;
    let (offset, bytes_per_row) = (offset as u64, Some(stride as u32));
    let layout = wgpu::TexelCopyBufferLayout { offset, bytes_per_row, rows_per_image: None };
    let [width, height] = level.size;
    let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    encoder.copy_texture_to_buffer(source, wgpu::TexelCopyBufferInfo { buffer, layout }, size);
}

/// A whole texture.
pub(super) fn plane(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Plane, RenderError> {
    let mips: Vec<Level<'_>> = (0..texture.mip_level_count()).map(|mip| Level::whole(texture, mip)).collect();
    let words = match texture.format() {
        wgpu::TextureFormat::R16Uint => Words::R16(texels(gpu, &mips)?),
        wgpu::TextureFormat::Rg16Uint => Words::Rg16(texels(gpu, &mips)?),
        wgpu::TextureFormat::R32Uint => Words::R32(texels(gpu, &mips)?.concat()),
        wgpu::TextureFormat::Rg32Uint => Words::Rg32(texels(gpu, &mips)?),
        wgpu::TextureFormat::Rgba32Uint => Words::Rgba32(texels(gpu, &mips)?.concat()),
        other => unreachable!("{other:?} is the format of no texture that is drawn"),
    };
    Ok(Plane { size: mips[0].size, words })
}
