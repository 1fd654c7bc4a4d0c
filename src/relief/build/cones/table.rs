//! Maxima of squares that begin at each node of a level.

use terrane_shaderlib::heightfield::cones::NEAR;

use crate::relief::build::level::{Level, layers};
use crate::relief::build::passes::{Part, Pass, Passes};

/// Layers of squares, of 1, 2, 4 nodes a side, up to the largest that is in one of a ring.
const SQUARES: u32 = NEAR.ilog2() + 1;
/// Nodes around a level: the last corner of the farthest cell is one more away.
const AROUND: u32 = NEAR as u32 + 1;

/// What draws them.
#[derive(Debug)]
pub(super) struct Tables {
    device: wgpu::Device,
    surrounded: Pass,
    joined: Pass,
}

/// Those of a level, and in a last layer the heights of the mip's texels.
pub(super) struct Table<'a> {
    tables: &'a Tables,
    pub(super) texture: wgpu::Texture,
}

impl Tables {
    pub(super) fn new(passes: &Passes<'_>, wraps: bool) -> Self {
        let constants = [CORNER, ("build_wraps", f64::from(u8::from(wraps)))];
        Self {
            device: passes.gpu.device.clone(),
            surrounded: passes.pass("build_surrounded", wgpu::TextureFormat::R16Uint, &constants),
            joined: passes.pass("build_joined", wgpu::TextureFormat::R16Uint, &[]),
        }
    }

    /// Room for one of any level of a mip.
    pub(super) fn room(&self, texels: [u32; 2]) -> Table<'_> {
        let size = texels.map(around);
        let texture = layers(&self.device, wgpu::TextureFormat::R16Uint, size, SQUARES + 1);
        Table { tables: self, texture }
    }
}

impl Table<'_> {
    /// Draws the heights of the texels.
    pub(super) fn ground(&self, encoder: &mut wgpu::CommandEncoder, heights: Level<'_>) {
        self.surround(encoder, heights, SQUARES);
    }

    /// Draws the squares of a level in place of those that were there.
    pub(super) fn draw(&self, encoder: &mut wgpu::CommandEncoder, nodes: Level<'_>) {
        self.surround(encoder, nodes, 0);
        for layer in 1..SQUARES {
            let [from, to] = [layer - 1, layer].map(|layer| self.layer(layer, nodes.size));
            let part = Part { first: [1 << (layer - 1); 2], ..Part::default() };
            self.tables.joined.draw_part(encoder, [from, to], part, &[to.size.map(|side| 0..side)]);
        }
    }

    fn surround(&self, encoder: &mut wgpu::CommandEncoder, level: Level<'_>, layer: u32) {
        let to = self.layer(layer, level.size);
        self.tables.surrounded.draw(encoder, level, to, &[to.size.map(|side| 0..side)]);
    }

    fn layer(&self, layer: u32, nodes: [u32; 2]) -> Level<'_> {
        Level { texture: &self.texture, mip: 0, layer, size: nodes.map(around) }
    }
}

/// A side with what is around it.
fn around(side: u32) -> u32 {
    side + 2 * AROUND
}

/// The override that says where a level begins in its table.
pub(super) const CORNER: (&str, f64) = ("build_around", AROUND as f64);
