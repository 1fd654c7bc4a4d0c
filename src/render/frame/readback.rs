//! Textures as bytes on the host.

use crate::render::error::Result;
use crate::render::gpu::Gpu;

/// Rows of a texture without padding.
pub(crate) fn read_bytes(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<u8>> {
    let size = texture.size();
    let texel = texture.format().block_copy_size(None).unwrap_or(4);
    // Rows of a copy are a multiple of 256 bytes apart.
    let stride = (size.width * texel).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.checked("read-back buffer", || {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read back"),
            size: u64::from(stride) * u64::from(size.height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        })
    })?;
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride), rows_per_image: None },
        },
        size,
    );
    gpu.queue.submit([encoder.finish()]);
    let mapped = gpu.read(&buffer)?;
    Ok(mapped.chunks_exact(stride as usize).flat_map(|row| &row[..(size.width * texel) as usize]).copied().collect())
}

/// The numbers of every texel of 16-bit floats, row by row.
pub(crate) fn read_halves(gpu: &Gpu, texture: &wgpu::Texture) -> Result<Vec<f32>> {
    let bytes = read_bytes(gpu, texture)?;
    Ok(bytes.chunks_exact(2).map(|b| half::f16::from_le_bytes([b[0], b[1]]).to_f32()).collect())
}

/// The depth of every sample, row by row.
pub(crate) fn read_depth(gpu: &Gpu, depth: &wgpu::Texture) -> Result<Vec<f32>> {
    let bytes = read_bytes(gpu, depth)?;
    Ok(bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect())
}
