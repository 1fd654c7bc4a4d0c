//! Maxima of squares that begin at each node of a level.

use terrane_shaderlib::heightfield::cones::NEAR;

use crate::relief::build::level::{Level, layers};
use crate::relief::build::parts::SIDE;
use crate::relief::build::passes::{Part, Pass, Passes};

/// Layers of squares, of 1, 2, 4 nodes a side, up to the largest that is in one of a ring.
const SQUARES: u32 = NEAR.ilog2() + 1;
/// Nodes around a level: the last corner of the farthest cell is one more away.
const AROUND: u32 = NEAR as u32 + 1;

/// Parts before one whose cells read what is drawn there: a cell c reads the table from c + 1 to c + 2 `AROUND`.
const BEFORE: u32 = (2 * AROUND).div_ceil(SIDE);

/// What draws them.
#[derive(Debug)]
pub(super) struct Tables {
    device: wgpu::Device,
    all: wgpu::BindGroup,
    surrounded: Pass,
    joined: Pass,
}

/// Those of a level, and in a last layer the heights of the mip's texels.
pub(super) struct Table<'a> {
    tables: &'a Tables,
    /// The parts of the mip that are drawn.
    pub(super) parts: &'a wgpu::BindGroup,
    pub(super) texture: wgpu::Texture,
}

impl Tables {
    pub(super) fn new(passes: &Passes<'_>, wraps: bool) -> Self {
        let constants = [CORNER, ("build_wraps", f64::from(u8::from(wraps)))];
        Self {
            device: passes.gpu.device.clone(),
            all: passes.parts.all.clone(),
            surrounded: passes.pass_of_parts("build_surrounded", FORMAT, &constants, (None, BEFORE)),
            joined: passes.pass_of_parts("build_joined", FORMAT, &[], (None, BEFORE)),
        }
    }

    /// Room for one of any level of a mip, of which some parts are drawn.
    pub(super) fn room<'a>(&'a self, texels: [u32; 2], parts: &'a wgpu::BindGroup) -> Table<'a> {
        let size = texels.map(around);
        let texture = layers(&self.device, FORMAT, size, SQUARES + 1);
        Table { tables: self, parts, texture }
    }
}

impl Table<'_> {
    /// Draws the heights of the texels.
    pub(super) fn ground(&self, encoder: &mut wgpu::CommandEncoder, heights: Level<'_>) {
        self.surround(encoder, heights, SQUARES, self.parts);
    }

    /// Draws the squares of a level in place of those that were there: of cells in parts, of larger nodes all.
    pub(super) fn draw(&self, encoder: &mut wgpu::CommandEncoder, nodes: Level<'_>) {
        let parts = if nodes.mip == 0 { self.parts } else { &self.tables.all };
        self.surround(encoder, nodes, 0, parts);
        for layer in 1..SQUARES {
            let [from, to] = [layer - 1, layer].map(|layer| self.layer(layer, nodes.size));
            let part = Part { first: [1 << (layer - 1); 2], behind: to.size, ..Part::default() };
            self.tables.joined.draw_parts(encoder, [from, to], part, (None, parts));
        }
    }

    fn surround(&self, encoder: &mut wgpu::CommandEncoder, level: Level<'_>, layer: u32, parts: &wgpu::BindGroup) {
        let to = self.layer(layer, level.size);
        let part = Part { behind: to.size, ..Part::default() };
        self.tables.surrounded.draw_parts(encoder, [level, to], part, (None, parts));
    }

    fn layer(&self, layer: u32, nodes: [u32; 2]) -> Level<'_> {
        Level { texture: &self.texture, mip: 0, layer, size: nodes.map(around) }
    }
}

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R16Uint;

/// A side with what is around it.
fn around(side: u32) -> u32 {
    side + 2 * AROUND
}

/// The override that says where a level begins in its table.
pub(super) const CORNER: (&str, f64) = ("build_around", AROUND as f64);
