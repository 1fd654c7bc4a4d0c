//! Textures as graphs declare them.

use crate::diagnostic::Span;

/// How the bytes of a texture are to be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ColorSpace {
    /// Colours, decoded to linear by the sampler.
    Srgb,
    /// Data.
    Linear,
}

/// What happens outside 0..1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Wrap {
    /// Tiles.
    Repeat,
    /// Keeps the border.
    Clamp,
    /// Tiles, every second one mirrored.
    Mirror,
}

/// How texels become a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Filter {
    /// Trilinear.
    Linear,
    /// The nearest texel of the nearest mip.
    Nearest,
}

/// A texture as a graph declares it.
#[derive(Clone, Debug)]
pub struct Texture {
    /// Its name.
    pub name: String,
    /// Project-relative, normalised, inside the root; a PNG.
    pub file: String,
    /// How to read it.
    pub color: ColorSpace,
    /// Index of the one channel that is meant; a node that returns the texel then returns this number.
    pub channel: Option<u8>,
    /// Outside 0..1.
    pub wrap: Wrap,
    /// Filter.
    pub filter: Filter,
    /// 1..16.
    pub anisotropy: u8,
    /// Width and height, from the PNG's header or the recipe that makes it.
    pub size: (u32, u32),
    /// Bits per channel of the file: 8 or 16.
    pub depth: u8,
    /// The name in the file.
    pub span: Span,
}
