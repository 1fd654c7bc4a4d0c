//! A pyramid over a map as the device builds it.

use terrane_shaderlib::heightfield::Heights;
use terrane_shaderlib::heightfield::pyramid::{self, Bound, Levels, level_sizes};
use terrane_shaderlib::relief::Region;

use super::level::Level;
use super::passes::Passes;
use super::quadtrees::Quadtrees;
use super::source::Source;
use super::{encoded, read};
use crate::render::{Gpu, RenderError};

/// The levels of [`terrane_shaderlib::heightfield::pyramid::Pyramid`] as the mips of one texture, equal to the last bit.
///
/// What bounds the surface from both sides is one of [`Bound::CellMax`] and one of [`Bound::CellMin`]. A level whose sides are no
/// powers of two stands in the first columns and rows of its mip; what is behind it means nothing. Texels are those of the map, of
/// floats the bits in whole numbers: no device rounds those.
#[derive(Debug)]
pub struct BuiltPyramid<'a> {
    gpu: &'a Gpu,
    source: Source,
    quadtrees: Quadtrees,
}

impl<'a> BuiltPyramid<'a> {
    /// Uploads a map and builds all levels over it.
    ///
    /// # Errors
    /// [`RenderError::Refused`] where the device has no room for them.
    pub fn new(gpu: &'a Gpu, heights: &Heights, bound: Bound) -> Result<Self, RenderError> {
        let passes = Passes::new(gpu)?;
        let finest = bound.nodes(heights);
        let built = gpu.checked("relief's pyramid", || {
            let source = Source::new(gpu, heights);
            let levels = level_sizes(finest).count() as u32;
            let quadtrees = Quadtrees::new(&passes, source.format(), bound, std::iter::once((finest, levels)));
            Self { gpu, source, quadtrees }
        })?;
        built.update(heights, &heights.size().map(|side| 0..side))?;
        Ok(built)
    }

    /// Brings the nodes over a rectangle of changed texels up to date: columns and rows inside the map.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    ///
    /// # Panics
    /// If the map has another size, border or kind of texels than that which was built.
    pub fn update(&self, heights: &Heights, texels: &Region) -> Result<(), RenderError> {
        if texels.iter().any(std::ops::Range::is_empty) {
            return Ok(());
        }
        self.source.upload(self.gpu, heights, texels)?;
        let nodes = self.quadtrees.bound.touched(heights, texels.clone());
        encoded(self.gpu, |encoder| {
            self.quadtrees.update(encoder, 0, self.source.level(), &nodes);
        })
    }

    /// The texture of all levels.
    #[must_use]
    pub fn texture(&self) -> &wgpu::Texture {
        self.quadtrees.texture(0)
    }

    /// What the device has made.
    ///
    /// # Errors
    /// [`RenderError::Lost`] where the device fails.
    pub fn read(&self) -> Result<Levels, RenderError> {
        Ok(match self.source.format() {
            wgpu::TextureFormat::R8Uint => Levels::U8(self.levels()?),
            wgpu::TextureFormat::R16Uint => Levels::U16(self.levels()?),
            _ => Levels::F32(self.levels()?),
        })
    }

    fn levels<T: bytemuck::Pod>(&self) -> Result<Vec<pyramid::Level<T>>, RenderError> {
        let levels: Vec<Level<'_>> = self.quadtrees.levels(0).collect();
        let values = read::texels(self.gpu, &levels)?;
        Ok(levels.iter().zip(values).map(|(level, values)| pyramid::Level { size: level.size, values }).collect())
    }
}
