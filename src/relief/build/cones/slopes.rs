//! The steepest way up from every cell.

use terrane_shaderlib::heightfield::cones::Ring;

use super::Ways;
use super::beside::Beside;
use super::table::{CORNER, Table};
use crate::relief::build::level::{Level, layers};
use crate::relief::build::passes::{Part, Pass, Passes};

/// What draws them.
#[derive(Debug)]
pub(super) struct Slopes {
    device: wgpu::Device,
    beside: wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
    steepened: Pass,
}

impl Slopes {
    pub(super) fn new(passes: &Passes<'_>, beside: wgpu::BindGroupLayout, ways: Ways) -> Self {
        let format = match ways {
            Ways::All => wgpu::TextureFormat::R32Float,
            Ways::Quadrants | Ways::Quadrant(_) => wgpu::TextureFormat::Rgba32Float,
        };
        let constants =
            [CORNER, ("build_is_round_about", f64::from(u8::from(format == wgpu::TextureFormat::R32Float)))];
        let steepened = passes.pass_of_parts("build_steepened", format, &constants, (Some(&beside), 0));
        Self { device: passes.gpu.device.clone(), beside, format, steepened }
    }

    /// Draws those of the table's parts from their tips and the maxima of these, level by level with its rings, and gives them as what
    /// is read beside the tips.
    pub(super) fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        table: &Table<'_>,
        tips: &[Level<'_>],
        rings: &[Vec<Ring>],
    ) -> wgpu::BindGroup {
        // New textures are zeros: at first nothing is steep.
        let pair = [0, 1].map(|_| layers(&self.device, self.format, tips[0].size, 1));
        let slopes = |drawn: usize| Level::whole(&pair[drawn % 2], 0);
        let bind = |drawn: usize, rings: &[Ring]| {
            let beside = Beside { table: &table.texture, slopes: slopes(drawn), rings: (drawn, rings) };
            beside.bind(&self.device, &self.beside)
        };
        for (level, (nodes, rings)) in tips.iter().zip(rings).enumerate() {
            table.draw(encoder, *nodes);
            let whole = Part { behind: tips[0].size, ..Part::default() };
            let read = (Some(&bind(level, rings)), table.parts);
            self.steepened.draw_parts(encoder, [tips[0], slopes(level + 1)], whole, read);
        }
        bind(rings.len(), &[])
    }
}
