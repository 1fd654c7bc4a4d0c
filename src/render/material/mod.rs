//! What a material reads: parameters, arrays of textures, samplers. Group 1.

mod decode;
mod mips;
mod upload;

pub(crate) use decode::{Samples, open, samples};
pub use decode::{Texels, decode};
pub use mips::mip_chain;
pub(super) use upload::MaterialGroup;
pub(crate) use upload::write_layer;

use std::path::PathBuf;

use terrane_shaderlib::relief::MapTexture;

pub use terrane_codegen::graph::model::{Filter, Wrap};
pub use terrane_codegen::program::Format;

/// The device's name of a format.
fn texture_format(format: Format) -> wgpu::TextureFormat {
    match format {
        Format::Rgba8UnormSrgb => wgpu::TextureFormat::Rgba8UnormSrgb,
        Format::Rgba8Unorm => wgpu::TextureFormat::Rgba8Unorm,
        Format::R8Unorm => wgpu::TextureFormat::R8Unorm,
        Format::R16Float => wgpu::TextureFormat::R16Float,
        Format::Rgba16Float => wgpu::TextureFormat::Rgba16Float,
    }
}

/// Numbers in a texel.
fn channels(format: Format) -> usize {
    match format {
        Format::R8Unorm | Format::R16Float => 1,
        Format::Rgba8UnormSrgb | Format::Rgba8Unorm | Format::Rgba16Float => 4,
    }
}

/// Files of one size that lie in one array.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextureArray {
    /// `@binding` in group 1.
    pub binding: u32,
    /// Width and height of every layer.
    pub size: (u32, u32),
    /// How to read the files.
    pub format: Format,
    /// PNG files, layer by layer.
    pub layers: Vec<PathBuf>,
}

/// How arrays are sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// `@binding` in group 1.
    pub binding: u32,
    /// Outside 0..1.
    pub wrap: Wrap,
    /// Between texels and mips.
    pub filter: Filter,
    /// 1..16; more than 1 only with [`Filter::Linear`].
    pub anisotropy: u8,
}

/// Everything in group 1, as the manifest lists it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Material {
    /// `@binding` and bytes of the uniform `TerrainParameters`, where there are parameters.
    pub parameters: Option<(u32, Vec<u8>)>,
    /// Texture arrays.
    pub arrays: Vec<TextureArray>,
    /// Samplers.
    pub samplers: Vec<Sampling>,
    /// Height maps that are traced.
    pub reliefs: Vec<Relief>,
}

/// Height maps of one size, and the textures that are made of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Relief {
    /// Width and height of every map.
    pub size: (u32, u32),
    /// `@binding` in group 1, and what stands there.
    pub textures: Vec<(u32, MapTexture)>,
    /// PNG files and the channel that counts, layer by layer.
    pub maps: Vec<(PathBuf, u8)>,
}
