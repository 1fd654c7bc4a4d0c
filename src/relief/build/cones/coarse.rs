//! Cones over coarse nodes of a map and its mips.
//!
//! ```text
//! a level of the quadtree --Corners--> the coarse map --Squares--> cones
//! ```

use terrane_shaderlib::heightfield::Border;
use terrane_shaderlib::relief::{COARSE, Extent, Region, coarse_texels};

use super::{Ground, Squares, Ways};
use crate::relief::build::level::{Level, layers};
use crate::relief::build::passes::{Pass, Passes};

/// What draws them.
#[derive(Debug)]
pub(in crate::relief::build) struct Coarse {
    device: wgpu::Device,
    border: Border,
    corners: Pass,
    /// Columns and rows of the coarse map, and those of nodes, mip by mip.
    sizes: Vec<([u32; 2], [u32; 2])>,
    squares: Squares,
}

impl Coarse {
    /// Those of a map.
    pub(in crate::relief::build) fn new(
        passes: &Passes<'_>,
        target: impl Into<wgpu::ColorTargetState>,
        (extent, border): (&Extent, Border),
    ) -> Self {
        let wraps = border == Border::Wrap;
        let mips = (0..extent.mips).filter(|mip| extent.coarse(*mip).is_some());
        let nodes = mips.map(|mip| extent.filled.map(|side| side >> (mip + COARSE)));
        // Of a map that ends the last nodes have corners behind them.
        let sizes: Vec<_> = nodes.map(|nodes| (nodes.map(|side| side + u32::from(!wraps)), nodes)).collect();
        let corners = sizes.iter().map(|(corners, _)| *corners).collect();
        let constants = [("build_wraps", f64::from(u8::from(wraps)))];
        Self {
            device: passes.gpu.device.clone(),
            border,
            corners: passes.pass("build_corners", CORNERS, &constants),
            squares: Squares::over(passes, target, (corners, border), Ways::Quadrants),
            sizes,
        }
    }

    /// Draws the cones of a mip that a change of some of its cells may have reached, from the quadtree over them.
    pub(in crate::relief::build) fn update(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        ground: &Ground<'_>,
        nodes: Level<'_>,
        cells: &[Region],
    ) {
        let (corners, size) = self.sizes[ground.mip as usize];
        let heights = layers(&self.device, CORNERS, corners, 1);
        let heights = Level::whole(&heights, 0);
        self.corners.draw(encoder, nodes, heights, &[corners.map(|side| 0..side)]);
        let texels = coarse_texels(cells, corners, self.border);
        self.squares.update(encoder, &Ground { heights, texels: &texels, size, ..*ground });
    }
}

const CORNERS: wgpu::TextureFormat = wgpu::TextureFormat::R16Uint;
