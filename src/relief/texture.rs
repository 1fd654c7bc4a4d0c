//! Planes of maps as textures.

use terrane_shaderlib::relief::{MapTexture, Plane, Words};
use wgpu::util::{DeviceExt as _, TextureDataOrder};

use super::setup::DeviceRay;
use super::shader::COLUMNS;
use crate::render::Gpu;
use crate::render::material::write_layer;

/// Uploads planes of one size and kind, a layer each.
pub(crate) fn textures(gpu: &Gpu, planes: &[&Plane]) -> wgpu::TextureView {
    let first = planes[0];
    let format = match &first.words {
        Words::R16(_) => wgpu::TextureFormat::R16Uint,
        Words::Rg16(_) => wgpu::TextureFormat::Rg16Uint,
        Words::R32(_) => wgpu::TextureFormat::R32Uint,
        Words::Rg32(_) => wgpu::TextureFormat::Rg32Uint,
        Words::Rgba32(_) => wgpu::TextureFormat::Rgba32Uint,
    };
    let usage = match &first.words {
        Words::R32(_) => wgpu::TextureUsages::STORAGE_BINDING,
        // Patches are stored, cones of quadrants are sampled.
        Words::Rg32(_) => wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::TEXTURE_BINDING,
        Words::R16(_) | Words::Rg16(_) | Words::Rgba32(_) => wgpu::TextureUsages::TEXTURE_BINDING,
    };
    let [width, height] = first.size;
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("relief"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: planes.len() as u32 },
        mip_level_count: first.mips() as u32,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: usage | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (layer, plane) in planes.iter().enumerate() {
        write_layer(gpu, &texture, layer as u32, &mips(plane));
    }
    let dimension = Some(wgpu::TextureViewDimension::D2Array);
    texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() })
}

/// How a texture over height maps is bound.
pub(crate) fn binding(texture: MapTexture) -> wgpu::BindingType {
    let view_dimension = wgpu::TextureViewDimension::D2Array;
    if !texture.is_storage() {
        let sample_type = wgpu::TextureSampleType::Uint;
        return wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false };
    }
    let format =
        if texture == MapTexture::Patches { wgpu::TextureFormat::Rg32Uint } else { wgpu::TextureFormat::R32Uint };
    wgpu::BindingType::StorageTexture { access: wgpu::StorageTextureAccess::ReadOnly, format, view_dimension }
}

/// The bytes of every mip.
fn mips(plane: &Plane) -> Vec<&[u8]> {
    match &plane.words {
        Words::R16(mips) => mips.iter().map(|mip| bytemuck::cast_slice(mip)).collect(),
        Words::Rg16(mips) => mips.iter().map(|mip| bytemuck::cast_slice(mip)).collect(),
        Words::R32(words) => vec![bytemuck::cast_slice(words)],
        Words::Rg32(mips) => mips.iter().map(|mip| bytemuck::cast_slice(mip)).collect(),
        Words::Rgba32(words) => vec![bytemuck::cast_slice(words)],
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
