//! A terrain: its shape and its materials.

use std::collections::BTreeMap;

use super::{GraphId, ReliefTrace, Texture};
use crate::diagnostic::{SourceId, Span};
use crate::value::Literal;

/// How a layer's mask is given beside the surface's own.
#[derive(Clone, Debug)]
pub enum LayerMask {
    /// Everywhere.
    Full,
    /// Red channel of an image over the whole terrain.
    Painted(Texture),
    /// A mask graph.
    Graph(GraphId),
}

/// One material on a terrain.
#[derive(Clone, Debug)]
pub struct Layer {
    /// A surface.
    pub surface: GraphId,
    /// By parameter name; checked against type and range.
    pub parameters: BTreeMap<String, Literal>,
    /// Multiplies the surface's own mask.
    pub mask: LayerMask,
    /// The entry in the file.
    pub span: Span,
}

/// How materials meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blend {
    /// Strict order, each mask over what lies below.
    Over,
    /// The highest surface wins (Drobot 1.7.3).
    HeightMax,
    /// Every surface within a band under the highest takes part.
    HeightSoft {
        /// In units of height, 0.001..1.
        band: f32,
    },
}

/// The height map of a terrain.
#[derive(Clone, Debug)]
pub struct HeightMap {
    /// Project-relative; a grey PNG, 8 or 16 bit.
    pub file: String,
    /// Texels.
    pub texels: (u32, u32),
    /// Metres on x and z.
    pub size: (f32, f32),
    /// Metres at 0 and at full white.
    pub range: (f32, f32),
    /// The entry in the file.
    pub span: Span,
}

/// A terrain file.
#[derive(Clone, Debug)]
pub struct Terrain {
    /// The file.
    pub source: SourceId,
    /// Project-relative path.
    pub path: String,
    /// File stem.
    pub name: String,
    /// What the author says of it.
    pub doc: String,
    /// Its shape.
    pub height: HeightMap,
    /// Side of a patch in metres.
    pub patch: f32,
    /// Bottom to top; at least one.
    pub layers: Vec<Layer>,
    /// How they meet.
    pub blend: Blend,
    /// How the displaced surface is traced; without it relief is shaded as normal mapping.
    pub relief: Option<ReliefTrace>,
    /// Whether the terrain throws shadows on itself.
    pub shadow: Shadow,
    /// Directions of the sky's occlusion by the terrain, 0 for none.
    pub occlusion: u32,
}

/// The sun's shadow at terrain scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shadow {
    /// None.
    Off,
    /// A horizon for each texel, in the sun's direction.
    Horizon,
}
