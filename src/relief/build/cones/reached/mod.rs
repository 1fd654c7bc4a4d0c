//! The parts of a level of cones that a change may have reached.
//!
//! ```text
//! tips before and after --Highest--> of each rectangle the highest --Reached, with the cones as they are--> parts
//! ```

#[cfg(test)]
mod tests;

use terrane_shaderlib::heightfield::Border;
use terrane_shaderlib::heightfield::cones::{Cones, shares};
use terrane_shaderlib::relief::{Region, inside};

use super::Ground;
use crate::relief::build::level::{Level, filled, layers};
use crate::relief::build::parts::{FORMAT, Parts, SIDE};
use crate::relief::build::passes::{Part, Pass, Passes, bound, texture};
use crate::relief::build::quadtrees::Quadtrees;

/// What draws them.
#[derive(Debug)]
pub(super) struct Reached {
    device: wgpu::Device,
    queue: wgpu::Queue,
    parts: Parts,
    border: Border,
    /// Toward the four quadrants.
    cones: [Cones; 4],
    beside: wgpu::BindGroupLayout,
    highest: Pass,
    reached: Pass,
}

/// Nodes whose highest is looked for one by one: those over a square of changed texels are 9 by 9 at most.
const NODES: u32 = 81;
/// More than what is found in f32 may be off.
const ROUNDING: f64 = 1e-6;
/// A share without end: more than `build_here`, and finite. Where one quadrant has it all have.
const HERE: f64 = 1e30;

impl Reached {
    /// For cones of some kind in a map with such a border; `constants` are those that they are stored with.
    pub(super) fn new(passes: &Passes<'_>, border: Border, cones: [Cones; 4], constants: &[(&str, f64)]) -> Self {
        let flag = |is: bool| f64::from(u8::from(is));
        let is_round = matches!(cones[0], Cones::Step | Cones::Relaxed);
        let round = ("build_is_round", flag(is_round));
        let quadrants = ("build_has_quadrants", flag(cones[0] != cones[1]));
        let kind = [("build_side", f64::from(SIDE)), round, quadrants];
        let beside = layout(&passes.gpu.device);
        Self {
            device: passes.gpu.device.clone(),
            queue: passes.gpu.queue.clone(),
            parts: passes.parts.clone(),
            border,
            cones,
            highest: passes.pass("build_highest_node", HIGHEST, &[round]),
            reached: passes.pass_beside("build_reached", FORMAT, &[&kind, constants].concat(), Some(&beside)),
            beside,
        }
    }

    /// Draws what has changed of the quadtree over what cones stand on, and asks of which parts cones are reached.
    pub(super) fn update<'t>(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        ground: &Ground<'_>,
        quadtrees: &'t Quadtrees,
        nodes: &[Region],
    ) -> (Vec<Level<'t>>, wgpu::BindGroup) {
        let levels: Vec<Level<'t>> = quadtrees.levels(ground.mip as usize).collect();
        let standing = levels[0].size;
        let nodes: Vec<Region> = nodes.iter().filter_map(|nodes| inside(nodes, standing)).collect();
        let highest = layers(&self.device, HIGHEST, [nodes.len() as u32, 2], 1);
        self.highest_of(encoder, &levels, &nodes, (&highest, 0));
        quadtrees.update(encoder, ground.mip as usize, ground.heights, &nodes);
        self.highest_of(encoder, &levels, &nodes, (&highest, 1));
        let parts = layers(&self.device, FORMAT, standing.map(|side| side.div_ceil(SIDE)), 1);
        let to = Level::whole(&parts, 0);
        let from = Level { size: standing, ..ground.image };
        self.reached.draw_beside(encoder, [from, to], ground.corner, &self.bind(ground, &highest));
        (levels, self.parts.bind(&parts))
    }

    /// Draws the highest of each of some regions of nodes into a row.
    fn highest_of(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        levels: &[Level<'_>],
        nodes: &[Region],
        (highest, row): (&wgpu::Texture, u32),
    ) {
        for (column, nodes) in (0..).zip(nodes) {
            let over =
                |level: usize| nodes.each_ref().map(|range| range.start >> level..((range.end - 1) >> level) + 1);
            let is_little =
                |level: &usize| over(*level).iter().map(|range| range.end - range.start).product::<u32>() <= NODES;
            let level = (0..levels.len() - 1).find(is_little).unwrap_or(levels.len() - 1);
            let [first, behind] = [over(level).map(|range| range.start), over(level).map(|range| range.end)];
            let part = Part { first, behind, ..Part::default() };
            let to = Level::whole(highest, 0);
            self.highest.draw_part(encoder, [levels[level], to], part, &[[column..column + 1, row..row + 1]]);
        }
    }

    fn bind(&self, ground: &Ground<'_>, highest: &wgpu::Texture) -> wgpu::BindGroup {
        let device = &self.device;
        let shares = self.shares(ground);
        let [shares, highest] = [&shares, highest].map(|texture| texture.create_view(&Default::default()));
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("relief's changes"),
            layout: &self.beside,
            entries: &[bound(6, &shares), bound(7, &highest)],
        })
    }

    /// A row for columns and one for rows: toward each quadrant the largest share of any of the rectangles, or that toward all.
    fn shares(&self, ground: &Ground<'_>) -> wgpu::Texture {
        let size = ground.heights.size;
        let side = size[0].max(size[1]);
        let mut texels = vec![[0.0f32; 4]; 2 * side as usize];
        let changed: Vec<Region> = ground.texels.iter().filter_map(|texels| inside(texels, size)).collect();
        let is_one = self.cones[0] == self.cones[1];
        for (quadrant, cones) in self.cones.into_iter().enumerate().take(if is_one { 1 } else { 4 }) {
            let axes = shares(cones, self.border, size, &changed);
            for (row, shares) in texels.chunks_exact_mut(side as usize).zip(axes) {
                for (texel, share) in row.iter_mut().zip(shares) {
                    texel[quadrant] = (share * (1.0 + ROUNDING)).min(HERE) as f32;
                }
            }
        }
        let (format, bytes) = (wgpu::TextureFormat::Rgba32Float, bytemuck::cast_slice(&texels));
        filled((&self.device, &self.queue), format, [side, 2], bytes)
    }
}

const HIGHEST: wgpu::TextureFormat = wgpu::TextureFormat::R16Uint;

fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    use wgpu::{TextureSampleType as Sample, TextureViewDimension as Dimension};
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("relief's changes"),
        entries: &[
            texture(6, Sample::Float { filterable: false }, Dimension::D2),
            texture(7, Sample::Uint, Dimension::D2),
        ],
    })
}
