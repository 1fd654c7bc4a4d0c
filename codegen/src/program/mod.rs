//! All materials of a terrain as one pool of values, where equal sub-trees are one value whatever file they came from.

mod affine;
mod build;
mod compact;
mod fold;
mod pool;
mod relief;
mod resource;

use std::collections::BTreeMap;

use terrane_shaderlib::relief::Platform;

use crate::diagnostic::Span;
use crate::graph::model::{Access, Blend, FrameField};
use crate::value::{Literal, Type};

pub(crate) use affine::affine;
pub(crate) use build::unique;
pub use pool::Pool;
pub use relief::{LayerRelief, ProgramRelief, ReliefArray, ReliefMap};
pub use resource::{Format, ProgramParameter, ProgramTexture, SamplerKey, TextureArray};

/// Names a value of a [`Program`]. The inputs of a value have smaller ids than the value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ValueId(pub usize);

/// How a value comes about.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Op {
    /// Known now.
    Literal(Literal),
    /// Given by the host.
    Frame(FrameField),
    /// A member of the uniform block: position in [`Program::parameters`].
    Parameter(usize),
    /// A texture with its sampler: position in [`Program::textures`].
    Texture(usize),
    /// A library function of all the inputs.
    Call(String),
    /// A part of the one input.
    Access(Access),
    /// The one input, a number, in every component of a vector.
    Widen,
    /// The product of two numbers.
    Product,
}

/// A value.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Value {
    /// How it comes about.
    pub op: Op,
    /// From what.
    pub inputs: Vec<ValueId>,
    /// Its type.
    pub ty: Type,
}

impl Value {
    /// Whether it is written where it is used, and gets no name of its own.
    pub fn is_inline(&self) -> bool {
        !matches!(self.op, Op::Call(_) | Op::Product)
    }
}

/// A node that a value stands for. Several nodes may share a value; the first one names it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Origin {
    /// Layer or mask, instance nodes, node: `granite/edge/grain`.
    pub path: String,
    /// The node in its file.
    pub span: Span,
}

/// One material in place.
#[derive(Clone, Debug)]
pub struct ProgramLayer {
    /// Surface name; `_2` and so on where a surface lies twice.
    pub name: String,
    /// The surface's file.
    pub path: String,
    /// What the author says of it.
    pub doc: String,
    /// The surface's own mask times the layer's.
    pub mask: ValueId,
    /// Every surface output but the mask, defaults filled in.
    pub outputs: BTreeMap<&'static str, ValueId>,
    /// Its displaced surface, where the terrain traces one.
    pub relief: Option<LayerRelief>,
    /// The layer in the terrain file, or the surface's name in its own.
    pub span: Span,
}

/// What stays optional, so that its gain can be measured and its correctness compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Equal sub-trees become one value.
    pub intern: bool,
    /// Calls with known arguments become literals where the arithmetic is exact.
    pub fold: bool,
    /// Layers are skipped where they cannot be seen.
    pub guard: bool,
    /// What the shader is to run on: which method `auto` stands for.
    pub platform: Platform,
}

impl Default for Options {
    fn default() -> Self {
        Self { intern: true, fold: true, guard: true, platform: Platform::Gpu }
    }
}

impl Options {
    /// Everything that the graphs say, literally.
    pub fn plain() -> Self {
        Self { intern: false, fold: false, guard: false, platform: Platform::Gpu }
    }
}

/// All materials of a terrain.
#[derive(Clone, Debug)]
pub struct Program {
    /// Terrain or surface name.
    pub name: String,
    /// Every value, inputs first.
    pub pool: Pool,
    /// Members of the uniform block.
    pub parameters: Vec<ProgramParameter>,
    /// Textures as the graphs use them.
    pub textures: Vec<ProgramTexture>,
    /// Textures as the GPU sees them: layers of equal size and format.
    pub arrays: Vec<TextureArray>,
    /// Distinct samplers.
    pub samplers: Vec<SamplerKey>,
    /// Bottom to top.
    pub layers: Vec<ProgramLayer>,
    /// How they meet.
    pub blend: Blend,
    /// How the displaced surface of the layers is traced, where any has one.
    pub relief: Option<ProgramRelief>,
}
