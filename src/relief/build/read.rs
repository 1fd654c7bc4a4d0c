//! Texels back from the device.

use crate::render::{Gpu, RenderError};

/// The 16-bit texels of a mip, row by row.
pub(super) fn texels(gpu: &Gpu, texture: &wgpu::Texture, mip: u32) -> Result<Vec<u16>, RenderError> {
    let size = texture.size().mip_level_size(mip, wgpu::TextureDimension::D2);
    let stride = (size.width * 2).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.checked("relief's texels", || {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("relief's texels"),
            size: u64::from(stride) * u64::from(size.height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        })
    })?;
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut source = texture.as_image_copy();
    source.mip_level = mip;
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride), rows_per_image: None };
    encoder.copy_texture_to_buffer(source, wgpu::TexelCopyBufferInfo { buffer: &buffer, layout }, size);
    gpu.queue.submit([encoder.finish()]);
    let bytes = gpu.read(&buffer)?;
    let rows = bytes.chunks_exact(stride as usize).map(|row| &row[..size.width as usize * 2]);
    Ok(rows.flat_map(|row| row.chunks_exact(2).map(|texel| u16::from_le_bytes([texel[0], texel[1]]))).collect())
}
