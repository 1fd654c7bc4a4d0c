//! Tables as textures.

use glam::{Vec3, Vec4};

use crate::render::error::Result;
use crate::render::gpu::Gpu;

/// A table that a shader reads.
pub(crate) struct Table {
    pub(crate) label: &'static str,
    /// Texels across, down and along, or layers.
    pub(crate) size: [u32; 3],
    pub(crate) dimension: wgpu::TextureViewDimension,
    pub(crate) format: wgpu::TextureFormat,
    /// Finest level first.
    pub(crate) levels: Vec<Vec<u8>>,
}

impl Table {
    /// Creates the texture and fills it.
    pub(crate) fn upload(&self, gpu: &Gpu) -> Result<wgpu::TextureView> {
        let [width, height, depth_or_array_layers] = self.size;
        let solid = self.dimension == wgpu::TextureViewDimension::D3;
        let texture = gpu.checked(self.label, || {
            gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(self.label),
                size: wgpu::Extent3d { width, height, depth_or_array_layers },
                mip_level_count: self.levels.len() as u32,
                sample_count: 1,
                dimension: if solid { wgpu::TextureDimension::D3 } else { wgpu::TextureDimension::D2 },
                format: self.format,
                usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
                view_formats: &[],
            })
        })?;
        for (level, bytes) in self.levels.iter().enumerate() {
            self.write(gpu, &texture, level as u32, bytes);
        }
        let dimension = Some(self.dimension);
        Ok(texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() }))
    }

    fn write(&self, gpu: &Gpu, texture: &wgpu::Texture, level: u32, bytes: &[u8]) {
        let [width, height] = [0, 1].map(|axis| (self.size[axis] >> level).max(1));
        let row = bytes.len() as u32 / (height * self.size[2]);
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo {
                texture,
                mip_level: level,
                origin: wgpu::Origin3d::ZERO,
                aspect: wgpu::TextureAspect::All,
            },
            bytes,
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: Some(height) },
            wgpu::Extent3d { width, height, depth_or_array_layers: self.size[2] },
        );
    }
}

/// Largest finite half float.
const HALF_LIMIT: f32 = 65504.0;

/// One channel in half floats.
pub(crate) fn halves(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|&value| half(value)).collect()
}

/// Three channels in half floats, the fourth 0: core WebGPU has no three-channel format.
pub(crate) fn half_colours(values: impl IntoIterator<Item = Vec3>) -> Vec<u8> {
    half_vectors(values.into_iter().map(|value| value.extend(0.0)))
}

/// Four channels in half floats.
pub(crate) fn half_vectors(values: impl IntoIterator<Item = Vec4>) -> Vec<u8> {
    values.into_iter().flat_map(|value| value.to_array()).flat_map(half).collect()
}

fn half(value: f32) -> [u8; 2] {
    half::f16::from_f32(value.clamp(-HALF_LIMIT, HALF_LIMIT)).to_le_bytes()
}

/// A map and its halvings, each the mean of 2 × 2 of the one before, down to 1 × 1; sizes as WebGPU rounds them.
pub(crate) fn mips(values: &[f32], size: [u32; 2]) -> Vec<Vec<f32>> {
    let mut levels = vec![values.to_vec()];
    let mut size = size;
    while size != [1, 1] {
        let smaller = size.map(|side| (side / 2).max(1));
        let level = halve(&levels[levels.len() - 1], size, smaller);
        levels.push(level);
        size = smaller;
    }
    levels
}

fn halve(values: &[f32], size: [u32; 2], smaller: [u32; 2]) -> Vec<f32> {
    let at = |x: u32, y: u32| values[(y.min(size[1] - 1) * size[0] + x.min(size[0] - 1)) as usize];
    let texel = |i: u32| {
        let (x, y) = (2 * (i % smaller[0]), 2 * (i / smaller[0]));
        (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) * 0.25
    };
    (0..smaller[0] * smaller[1]).map(texel).collect()
}
