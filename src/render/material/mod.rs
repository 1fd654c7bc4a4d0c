//! What a material reads: parameters, arrays of textures, samplers. Group 1.

mod decode;
mod mips;
mod upload;

pub use decode::{Texels, decode};
pub use mips::mip_chain;
pub(super) use upload::MaterialGroup;

use std::path::PathBuf;

pub use terrane_codegen::graph::model::{Filter, Wrap};

/// How texels are stored and decoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Four channels of 8 bits; colours in sRGB.
    Srgb8,
    /// Four channels of 8 bits, data.
    Linear8,
    /// One channel of 16 bits, data; half floats on the device.
    Linear16,
}

impl Encoding {
    pub(super) fn format(self) -> wgpu::TextureFormat {
        match self {
            Self::Srgb8 => wgpu::TextureFormat::Rgba8UnormSrgb,
            Self::Linear8 => wgpu::TextureFormat::Rgba8Unorm,
            Self::Linear16 => wgpu::TextureFormat::R16Float,
        }
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
    pub encoding: Encoding,
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
}
