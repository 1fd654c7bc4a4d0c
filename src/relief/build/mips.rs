//! The heights of a map and their mips.

use terrane_shaderlib::relief::{Extent, Region, halved};

use super::level::{Level, texture};
use super::passes::{Pass, Passes};

/// The texture of them.
#[derive(Debug)]
pub(super) struct Mips {
    extent: Extent,
    pub(super) texture: wgpu::Texture,
    fill: Pass,
    halve: Pass,
}

impl Mips {
    /// Room for those of a map.
    pub(super) fn new(passes: &Passes<'_>, extent: Extent) -> Self {
        let format = wgpu::TextureFormat::R16Uint;
        let seam = [("build_seam", f64::from(u8::from(extent.is_tiled())))];
        Self {
            extent,
            texture: texture(passes.gpu, format, extent.filled, extent.mips, wgpu::TextureUsages::empty()),
            fill: passes.pass("build_fill", format, &seam),
            halve: passes.pass("build_mip", format, &[]),
        }
    }

    pub(super) fn level(&self, mip: u32) -> Level<'_> {
        Level::whole(&self.texture, mip)
    }

    /// Draws what depends on a rectangle of the map, and says which texels of each mip that is.
    pub(super) fn update(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        source: Level<'_>,
        texels: &Region,
    ) -> Vec<Vec<Region>> {
        let mut all = vec![self.extent.texels(texels)];
        self.fill.draw(encoder, source, self.level(0), &all[0]);
        for mip in 1..self.extent.mips {
            let changed = halved(&all[mip as usize - 1]);
            self.halve.draw(encoder, self.level(mip - 1), self.level(mip), &changed);
            all.push(changed);
        }
        all
    }
}
