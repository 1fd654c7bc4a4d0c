//! Group 1: the resources that the generated core takes as arguments.

use std::path::Path;

use super::device::Device;
use super::manifest::{Manifest, Parameters, Sampler, Texture};
use super::texture::{format, mips};

/// Binds everything in the order in which shader.rs declares it. Files lie under `root`.
pub(crate) fn bind(
    device: &Device,
    layout: &wgpu::BindGroupLayout,
    manifest: &Manifest,
    root: &Path,
) -> Result<wgpu::BindGroup, String> {
    let parameters = manifest.parameters.as_ref().map(|block| device.uniform(&defaults(block)));
    let textures = manifest.textures.iter().map(|texture| upload(device, texture, root));
    let textures = textures.collect::<Result<Vec<_>, _>>()?;
    let samplers = manifest.samplers.iter().map(|info| sampler(device, info)).collect::<Result<Vec<_>, _>>()?;
    let uniform = parameters.iter().map(wgpu::Buffer::as_entire_binding);
    let textures = textures.iter().map(wgpu::BindingResource::TextureView);
    let samplers = samplers.iter().map(wgpu::BindingResource::Sampler);
    let resources = uniform.chain(textures).chain(samplers).enumerate();
    let entries: Vec<_> =
        resources.map(|(binding, resource)| wgpu::BindGroupEntry { binding: binding as u32, resource }).collect();
    let descriptor = wgpu::BindGroupDescriptor { label: Some("material"), layout, entries: &entries };
    Ok(device.device.create_bind_group(&descriptor))
}

/// The uniform block with every parameter as its author left it.
fn defaults(block: &Parameters) -> Vec<u8> {
    let mut bytes = vec![0; block.size.next_multiple_of(16)];
    for parameter in &block.members {
        let value: &[u8] = bytemuck::cast_slice(&parameter.default);
        bytes[parameter.offset..parameter.offset + value.len()].copy_from_slice(value);
    }
    bytes
}

fn upload(device: &Device, info: &Texture, root: &Path) -> Result<wgpu::TextureView, String> {
    let format = format(&info.format)?;
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    let levels = info.width.max(info.height).ilog2() + 1;
    let texture = device.texture([info.width, info.height, info.layers.len() as u32], levels, format, usage);
    for (layer, file) in info.layers.iter().enumerate() {
        for (level, bytes) in mips(&root.join(file), [info.width, info.height], format)?.iter().enumerate() {
            device.fill(&texture, layer as u32, level as u32, bytes);
        }
    }
    // An array of one layer is still an array.
    let dimension = Some(wgpu::TextureViewDimension::D2Array);
    Ok(texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() }))
}

fn sampler(device: &Device, info: &Sampler) -> Result<wgpu::Sampler, String> {
    let address = match info.address_mode.as_str() {
        "repeat" => wgpu::AddressMode::Repeat,
        "clamp-to-edge" => wgpu::AddressMode::ClampToEdge,
        "mirror-repeat" => wgpu::AddressMode::MirrorRepeat,
        unknown => return Err(format!("no address mode `{unknown}`")),
    };
    let (filter, mips) = match info.filter.as_str() {
        "linear" => (wgpu::FilterMode::Linear, wgpu::MipmapFilterMode::Linear),
        "nearest" => (wgpu::FilterMode::Nearest, wgpu::MipmapFilterMode::Nearest),
        unknown => return Err(format!("no filter `{unknown}`")),
    };
    Ok(device.device.create_sampler(&wgpu::SamplerDescriptor {
        address_mode_u: address,
        address_mode_v: address,
        mag_filter: filter,
        min_filter: filter,
        mipmap_filter: mips,
        anisotropy_clamp: info.max_anisotropy,
        ..Default::default()
    }))
}
