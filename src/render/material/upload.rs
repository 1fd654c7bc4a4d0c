//! A material on the device.

use std::path::PathBuf;

use rayon::prelude::*;
use terrane_shaderlib::relief::{MapTexture, Plane};

use super::{Filter, Material, Relief, Sampling, TextureArray, Wrap, decode, mip_chain, texture_format};
use crate::relief::map;
use crate::relief::texture::{binding, textures};
use crate::render::error::Result;
use crate::render::gpu::Gpu;
use crate::render::progress::{Phase, Progress};

/// Group 1: its layout, which is the same for every shader of a terrain, and what is bound.
#[derive(Debug)]
pub(crate) struct MaterialGroup {
    pub(crate) layout: wgpu::BindGroupLayout,
    pub(crate) group: wgpu::BindGroup,
}

impl MaterialGroup {
    /// Reads the files, builds their mips on all cores, and uploads them.
    pub(crate) fn new(gpu: &Gpu, material: &Material, progress: Progress) -> Result<Self> {
        let layers = material.arrays.iter().map(|array| array.layers.len()).sum::<usize>();
        let maps = material.reliefs.iter().map(|relief| relief.maps.len()).sum::<usize>();
        let phase = progress.phase("textures", (layers + maps) as u64);
        let arrays: Vec<wgpu::TextureView> =
            material.arrays.iter().map(|array| upload(gpu, array, &phase)).collect::<Result<_>>()?;
        let reliefs = material.reliefs.iter().map(|relief| upload_relief(gpu, relief, &phase));
        let reliefs: Vec<Vec<MapView>> = reliefs.collect::<Result<_>>()?;
        gpu.checked("material's bindings", || bind(gpu, material, &arrays, &reliefs))
    }
}

/// A texture over height maps, and where it is bound.
struct MapView {
    at: u32,
    texture: MapTexture,
    view: wgpu::TextureView,
}

fn upload_relief(gpu: &Gpu, relief: &Relief, phase: &Phase) -> Result<Vec<MapView>> {
    let wanted: Vec<MapTexture> = relief.textures.iter().map(|(_, texture)| *texture).collect();
    let read = |(path, channel): &(PathBuf, u8)| {
        let planes = map(path, *channel, relief.size, &wanted);
        phase.advance(1);
        planes
    };
    let maps: Vec<Vec<Plane>> = relief.maps.par_iter().map(read).collect::<Result<_>>()?;
    let view = |(index, (at, texture)): (usize, &(u32, MapTexture))| {
        let planes: Vec<&Plane> = maps.iter().map(|planes| &planes[index]).collect();
        MapView { at: *at, texture: *texture, view: textures(gpu, &planes) }
    };
    gpu.checked("height maps", || relief.textures.iter().enumerate().map(view).collect())
}

fn upload(gpu: &Gpu, array: &TextureArray, phase: &Phase) -> Result<wgpu::TextureView> {
    let size =
        wgpu::Extent3d { width: array.size.0, height: array.size.1, depth_or_array_layers: array.layers.len() as u32 };
    let texture = gpu.checked("texture array", || {
        gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("material textures"),
            size,
            mip_level_count: size.max_mips(wgpu::TextureDimension::D2),
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: texture_format(array.format),
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        })
    })?;
    // A few layers at a time: a layer's chain in floats is 20 bytes per texel.
    for (base, paths) in array.layers.chunks(rayon::current_num_threads()).enumerate() {
        let chains: Vec<Vec<Vec<u8>>> = paths
            .par_iter()
            .map(|path| {
                let texels = decode(path, array.size, array.format)?;
                let chain = mip_chain(&texels, array.format);
                phase.advance(1);
                Ok(chain)
            })
            .collect::<Result<_>>()?;
        for (offset, chain) in chains.iter().enumerate() {
            write_layer(gpu, &texture, (base * rayon::current_num_threads() + offset) as u32, chain);
        }
    }
    let dimension = Some(wgpu::TextureViewDimension::D2Array);
    Ok(texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() }))
}

/// Writes a layer of a texture array, mip after mip, without padding between rows.
pub(crate) fn write_layer<B: AsRef<[u8]>>(gpu: &Gpu, texture: &wgpu::Texture, layer: u32, chain: &[B]) {
    // Only depth and video have no size of their own.
    let texel = texture.format().block_copy_size(None).unwrap_or_default();
    for (level, bytes) in chain.iter().enumerate() {
        let (width, height) = ((texture.width() >> level).max(1), (texture.height() >> level).max(1));
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo {
                texture,
                mip_level: level as u32,
                origin: wgpu::Origin3d { x: 0, y: 0, z: layer },
                aspect: wgpu::TextureAspect::All,
            },
            bytes.as_ref(),
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(width * texel), rows_per_image: Some(height) },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
    }
}

fn bind(gpu: &Gpu, material: &Material, arrays: &[wgpu::TextureView], reliefs: &[Vec<MapView>]) -> MaterialGroup {
    let parameters = material.parameters.as_ref().map(|(binding, bytes)| (*binding, uniform(gpu, bytes)));
    let samplers: Vec<wgpu::Sampler> = material.samplers.iter().map(|sampling| sampler(gpu, *sampling)).collect();
    let mut layout = Vec::new();
    let mut entries = Vec::new();
    let mut add = |binding, ty, resource| {
        let visibility = wgpu::ShaderStages::FRAGMENT;
        layout.push(wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None });
        entries.push(wgpu::BindGroupEntry { binding, resource });
    };
    if let Some((binding, buffer)) = &parameters {
        let ty = wgpu::BufferBindingType::Uniform;
        let ty = wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
        add(*binding, ty, buffer.as_entire_binding());
    }
    for (array, view) in material.arrays.iter().zip(arrays) {
        let ty = texture_array(wgpu::TextureSampleType::Float { filterable: true });
        add(array.binding, ty, wgpu::BindingResource::TextureView(view));
    }
    for MapView { at, texture, view } in reliefs.iter().flatten() {
        add(*at, binding(*texture), wgpu::BindingResource::TextureView(view));
    }
    for (sampling, sampler) in material.samplers.iter().zip(&samplers) {
        let ty = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
        add(sampling.binding, ty, wgpu::BindingResource::Sampler(sampler));
    }
    let layout = gpu
        .device
        .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("material"), entries: &layout });
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("material"),
        layout: &layout,
        entries: &entries,
    });
    MaterialGroup { layout, group }
}

fn texture_array(sample_type: wgpu::TextureSampleType) -> wgpu::BindingType {
    let view_dimension = wgpu::TextureViewDimension::D2Array;
    wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false }
}

fn uniform(gpu: &Gpu, bytes: &[u8]) -> wgpu::Buffer {
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("terrain parameters"),
        // A uniform's size is a multiple of its alignment, 16.
        size: (bytes.len() as u64).next_multiple_of(16),
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut padded = bytes.to_vec();
    padded.resize(bytes.len().next_multiple_of(16), 0);
    gpu.queue.write_buffer(&buffer, 0, &padded);
    buffer
}

fn sampler(gpu: &Gpu, sampling: Sampling) -> wgpu::Sampler {
    let wrap = match sampling.wrap {
        Wrap::Repeat => wgpu::AddressMode::Repeat,
        Wrap::Clamp => wgpu::AddressMode::ClampToEdge,
        Wrap::Mirror => wgpu::AddressMode::MirrorRepeat,
    };
    let (filter, mips) = match sampling.filter {
        Filter::Linear => (wgpu::FilterMode::Linear, wgpu::MipmapFilterMode::Linear),
        Filter::Nearest => (wgpu::FilterMode::Nearest, wgpu::MipmapFilterMode::Nearest),
    };
    gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("material"),
        address_mode_u: wrap,
        address_mode_v: wrap,
        address_mode_w: wrap,
        mag_filter: filter,
        min_filter: filter,
        mipmap_filter: mips,
        anisotropy_clamp: gpu.anisotropy(sampling.anisotropy),
        ..Default::default()
    })
}
