//! A map placed by the device itself: the textures of [`terrane_shaderlib::relief::planes`] and the levels of
//! [`terrane_shaderlib::heightfield::pyramid::Pyramid`], equal to the last bit but for round cones.
//!
//! ```text
//! Heights --Source--> its texels --Mips--> heights --Quadtrees--> levels of a bound --Image--> textures
//!                                          heights --Squares, Rounds--> cones
//!                               a level of a bound --Coarse--> cones over its nodes
//! ```
//!
//! Every arrow is a pass that draws, and draws only what a rectangle has changed; of cones the parts in which it reaches one.
//! Whole are but the tables over nodes larger than cells, and the corners of coarse nodes.

mod cones;
mod image;
mod level;
mod mips;
mod parts;
mod passes;
mod pyramid;
mod quadtrees;
mod read;
mod source;
mod strip;

use terrane_shaderlib::heightfield::pyramid::Bound;
use terrane_shaderlib::heightfield::{Heights, Texels};
use terrane_shaderlib::relief::{Extent, MapTexture, Plane, Region, Unplaceable};

use self::image::{Change, Image};
use self::mips::Mips;
use self::passes::Passes;
use self::quadtrees::Quadtrees;
use self::source::Source;
use crate::render::{Gpu, RenderError};

pub use self::pyramid::BuiltPyramid;

/// A map, its mips and the bounds of all of them, as textures that shaders read.
///
/// Square cones are those of the host. Round ones are never wider and at most one code narrower, which is a 2048th of the ratio.
/// While a mip's cones are built they take, beside the texture, for each of its texels 17 bytes of tips and of squares and 8 of
/// slopes, 32 for the four quadrants, or 11 of maxima and 16 of searches for round ones; what no later change needs goes when the
/// device is done. Squares reach 33 texels beyond the border, so a side may be 66 shorter than the device's longest at most.
#[derive(Debug)]
pub struct Built<'a> {
    gpu: &'a Gpu,
    extent: Extent,
    source: Source,
    mips: Mips,
    /// Those that images are drawn from, one for each mip.
    quadtrees: Vec<Quadtrees>,
    images: Vec<Image>,
}

impl<'a> Built<'a> {
    /// Uploads a map and builds textures over it.
    ///
    /// # Errors
    /// [`RenderError::Scene`] for a map of floats; what the device has against it.
    pub fn new(gpu: &'a Gpu, heights: &Heights, textures: &[MapTexture]) -> Result<Self, RenderError> {
        if let Texels::F32(_) = heights.texels() {
            return Err(RenderError::Scene(Unplaceable::Floats.to_string()));
        }
        let extent = Extent::new(heights);
        let passes = Passes::new(gpu)?;
        let image = |mips: &Mips, texture| Image::new(&passes, (&extent, heights.border()), mips, texture);
        let built = gpu.checked("relief's bounds", || {
            let mips = Mips::new(&passes, extent);
            Self {
                gpu,
                extent,
                source: Source::new(gpu, heights),
                quadtrees: quadtrees(&passes, &extent, textures),
                images: textures.iter().map(|texture| image(&mips, *texture)).collect(),
                mips,
            }
        })?;
        built.update(heights, &extent.size.map(|side| 0..side))?;
        Ok(built)
    }

    /// Brings what depends on a rectangle of changed texels up to date: columns and rows inside the map. Cones are built anew
    /// where it may have reached one, as [`ConeMap::update`](terrane_shaderlib::heightfield::cones::ConeMap::update) asks.
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
        encoded(self.gpu, |encoder| {
            let mips = self.mips.update(encoder, self.source.level(), texels);
            for (mip, changed) in mips.iter().enumerate() {
                let change = self.over(encoder, mip, changed);
                self.images.iter().for_each(|image| image.update(encoder, &self.extent, &change));
            }
        })
    }

    /// The textures, in the order in which they were asked for.
    pub fn textures(&self) -> impl Iterator<Item = &wgpu::Texture> {
        self.images.iter().map(|image| &image.texture)
    }

    /// What the device has made of each of them.
    ///
    /// # Errors
    /// [`RenderError::Lost`] where the device fails.
    pub fn read(&self) -> Result<Vec<Plane>, RenderError> {
        self.textures().map(|texture| read::plane(self.gpu, texture)).collect()
    }

    /// Draws the quadtrees over some texels of a mip.
    fn over<'t>(&'t self, encoder: &mut wgpu::CommandEncoder, mip: usize, texels: &'t [Region]) -> Change<'t> {
        let heights = self.mips.level(mip as u32);
        let cells = self.extent.cells(mip as u32, texels);
        let mut change = Change { mip: mip as u32, heights, texels, cells, quadtrees: Vec::new() };
        for quadtrees in &self.quadtrees {
            let nodes = if quadtrees.bound == Bound::TexelMax { texels } else { &change.cells };
            let levels = quadtrees.update(encoder, mip, heights, nodes);
            change.quadtrees.push((quadtrees.bound, levels));
        }
        change
    }
}

/// Room for the quadtrees over every mip that textures are drawn from. Levels whose sides are no longer both halved stay away.
fn quadtrees(passes: &Passes<'_>, extent: &Extent, textures: &[MapTexture]) -> Vec<Quadtrees> {
    let wanted = [Bound::CellMax, Bound::TexelMax].into_iter();
    let wanted = wanted.filter(|bound| textures.iter().any(|texture| image::bound(*texture) == Some(*bound)));
    let finest = || (0..extent.mips).map(|mip| (extent.filled.map(|side| side >> mip), extent.levels(mip)));
    wanted.map(|bound| Quadtrees::new(passes, wgpu::TextureFormat::R16Uint, bound, finest())).collect()
}

/// Encodes passes and submits them.
fn encoded(gpu: &Gpu, encode: impl FnOnce(&mut wgpu::CommandEncoder)) -> Result<(), RenderError> {
    gpu.checked("relief's bounds", || {
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encode(&mut encoder);
        gpu.queue.submit([encoder.finish()]);
    })
}
