//! What the values read: parameters, textures, samplers.

use crate::graph::model::{ColorSpace, Filter, Texture, Wrap};
use crate::value::{Literal, Type};

/// A member of the uniform block `TerrainParameters`.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramParameter {
    /// `<surface>_<parameter>`.
    pub name: String,
    /// A number or vector.
    pub ty: Type,
    /// Whether the vector is a linear Rec. 709 colour.
    pub color: bool,
    /// Unit.
    pub unit: Option<String>,
    /// Inclusive.
    pub range: Option<(f32, f32)>,
    /// The value until somebody tweaks it.
    pub default: Literal,
    /// What the author says of it.
    pub doc: String,
}

/// How texels lie in memory: formats that core WebGPU filters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Format {
    /// Colour.
    Rgba8UnormSrgb,
    /// Data of 8 bits.
    Rgba8Unorm,
    /// One channel of 8 bits.
    R8Unorm,
    /// One channel of 16 bits: 11 significant bits.
    R16Float,
    /// Four channels of 16 bits.
    Rgba16Float,
}

impl Format {
    /// The format that a declared texture needs.
    pub fn of(texture: &Texture) -> Self {
        match (texture.color, texture.depth, texture.channel) {
            (ColorSpace::Srgb, _, _) => Self::Rgba8UnormSrgb,
            (ColorSpace::Linear, 16, Some(0)) => Self::R16Float,
            (ColorSpace::Linear, 16, _) => Self::Rgba16Float,
            (ColorSpace::Linear, _, Some(0)) => Self::R8Unorm,
            (ColorSpace::Linear, _, _) => Self::Rgba8Unorm,
        }
    }

    /// As WebGPU spells it.
    pub fn webgpu(self) -> &'static str {
        match self {
            Self::Rgba8UnormSrgb => "rgba8unorm-srgb",
            Self::Rgba8Unorm => "rgba8unorm",
            Self::R8Unorm => "r8unorm",
            Self::R16Float => "r16float",
            Self::Rgba16Float => "rgba16float",
        }
    }

    /// Short, for names in WGSL.
    pub fn word(self) -> &'static str {
        match self {
            Self::Rgba8UnormSrgb => "color",
            Self::Rgba8Unorm => "data",
            Self::R8Unorm => "gray",
            Self::R16Float => "fine_gray",
            Self::Rgba16Float => "fine_data",
        }
    }
}

/// Everything that distinguishes samplers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SamplerKey {
    /// Outside 0..1.
    pub wrap: Wrap,
    /// Between texels and mips.
    pub filter: Filter,
    /// 1..16.
    pub anisotropy: u8,
}

impl SamplerKey {
    /// The sampler that a declared texture needs.
    pub fn of(texture: &Texture) -> Self {
        Self { wrap: texture.wrap, filter: texture.filter, anisotropy: texture.anisotropy }
    }

    /// Its name in WGSL: `repeat_linear_8_sampler`.
    pub fn name(self) -> String {
        let wrap = match self.wrap {
            Wrap::Repeat => "repeat",
            Wrap::Clamp => "clamp",
            Wrap::Mirror => "mirror",
        };
        let filter = match self.filter {
            Filter::Linear => "linear",
            Filter::Nearest => "nearest",
        };
        format!("{wrap}_{filter}_{}_sampler", self.anisotropy)
    }
}

/// A texture as a graph uses it: a layer of an array, and a sampler.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProgramTexture {
    /// Position in [`super::Program::arrays`].
    pub array: usize,
    /// Layer of that array.
    pub layer: usize,
    /// Position in [`super::Program::samplers`].
    pub sampler: usize,
}

/// Files of equal size and format, one a layer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextureArray {
    /// How the texels lie in memory.
    pub format: Format,
    /// Width and height.
    pub size: (u32, u32),
    /// Project-relative files, in the order of the layers.
    pub files: Vec<String>,
}

impl TextureArray {
    /// Its name in WGSL: `color_1024x1024`.
    pub fn name(&self) -> String {
        format!("{}_{}x{}", self.format.word(), self.size.0, self.size.1)
    }
}
