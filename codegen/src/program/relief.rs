//! The displaced surfaces of a program's layers.

use std::collections::BTreeSet;

use terrane_shaderlib::relief::{MapTexture, Method};

use crate::diagnostic::Span;
use crate::graph::model::{ReliefMethod, ReliefShadow, ReliefTrace};

use super::{Program, ValueId};

/// How a program's displaced surface is traced, and the maps that it is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramRelief {
    /// How.
    pub trace: ReliefTrace,
    /// What searches.
    pub method: Method,
    /// Height maps of equal size, one a layer.
    pub arrays: Vec<ReliefArray>,
}

impl ProgramRelief {
    /// The textures over the maps of an array: what the method reads, and what light reads where there is any.
    pub fn textures(&self) -> Vec<MapTexture> {
        let lit = self.trace.shadow != ReliefShadow::Off || self.trace.occlusion > 0;
        let light = MapTexture::LIGHT.into_iter().filter(|_| lit);
        light.chain(self.searched()).collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// What a search reads: the method's textures, and the heights where a single look at them may do.
    pub fn searched(&self) -> Vec<MapTexture> {
        let looks = matches!(self.trace.method, ReliefMethod::Auto { .. });
        let heights = looks.then_some(MapTexture::Heights);
        heights.into_iter().chain(self.method.reads()).collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// All arrays with their textures, in the order in which they are bound and passed on.
    pub fn maps(&self) -> impl Iterator<Item = (&ReliefArray, MapTexture)> {
        self.arrays.iter().flat_map(|array| self.textures().into_iter().map(move |texture| (array, texture)))
    }
}

impl Program {
    /// The textures over height maps that are storage textures, or those that are sampled.
    pub fn maps(&self, storage: bool) -> impl Iterator<Item = (&ReliefArray, MapTexture)> {
        let all = self.relief.iter().flat_map(ProgramRelief::maps);
        all.filter(move |(_, texture)| texture.is_storage() == storage)
    }
}

/// Height maps of one size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReliefArray {
    /// Texels.
    pub size: (u32, u32),
    /// In the order of the layers.
    pub maps: Vec<ReliefMap>,
}

impl ReliefArray {
    /// The name of a texture over its maps in WGSL: `relief_1024x1024_heights`.
    pub fn name(&self, texture: MapTexture) -> String {
        format!("relief_{}x{}_{}", self.size.0, self.size.1, texture.name())
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
