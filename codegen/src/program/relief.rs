//! The displaced surfaces of a program's layers.

use crate::diagnostic::Span;
use crate::graph::model::ReliefTrace;

use super::ValueId;

/// How a program's displaced surface is traced, and the maps that it is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramRelief {
    /// How.
    pub trace: ReliefTrace,
    /// Height maps of equal size, one a layer.
    pub arrays: Vec<ReliefArray>,
}

/// Height maps of one size: two textures, of heights and of their bounds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReliefArray {
    /// Texels.
    pub size: (u32, u32),
    /// In the order of the layers.
    pub maps: Vec<ReliefMap>,
}

impl ReliefArray {
    /// The name of its heights in WGSL: `relief_1024x1024_heights`.
    pub fn heights(&self) -> String {
        format!("relief_{}x{}_heights", self.size.0, self.size.1)
    }

    /// The name of its bounds in WGSL: `relief_1024x1024_bounds`.
    pub fn bounds(&self) -> String {
        format!("relief_{}x{}_bounds", self.size.0, self.size.1)
    }
}

/// A channel of an image that is a height map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReliefMap {
    /// Project-relative PNG.
    pub file: String,
    /// Its channel.
    pub channel: u8,
}

/// The displaced surface of one layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayerRelief {
    /// Position in [`ProgramRelief::arrays`].
    pub array: usize,
    /// Layer of that array.
    pub layer: usize,
    /// A `Coord`, affine in the position.
    pub uv: ValueId,
    /// Metres from height 1 down to height 0.
    pub depth: f32,
    /// The entry in the file.
    pub span: Span,
}
