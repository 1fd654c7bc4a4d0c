//! Round cones over the texels of a map and its mips.

use terrane_shaderlib::heightfield::Border;
use terrane_shaderlib::heightfield::cones::{Cones, RATIO};
use terrane_shaderlib::heightfield::pyramid::level_sizes;
use terrane_shaderlib::relief::{Extent, around};

use super::Ground;
use super::reached::Reached;
use crate::relief::build::level::{Level, layers};
use crate::relief::build::passes::{Part, Pass, Passes, bound, texture};
use crate::relief::build::quadtrees::Quadtrees;

/// Nodes that a pass goes through: some drivers leave a shader's loops after 65535 rounds.
const ROUNDS: u32 = 1 << 15;

/// What draws them.
#[derive(Debug)]
pub(in crate::relief::build) struct Rounds {
    device: wgpu::Device,
    /// Columns and rows of texels, mip by mip.
    sizes: Vec<[u32; 2]>,
    /// Four maxima to a node, one for each quadrant of directions.
    quadtrees: Quadtrees,
    reached: Reached,
    beside: wgpu::BindGroupLayout,
    searched: Pass,
    codes: Pass,
}

impl Rounds {
    /// Those of a map.
    pub(in crate::relief::build) fn new(
        passes: &Passes<'_>,
        format: wgpu::TextureFormat,
        (extent, border): (&Extent, Border),
        cones: Cones,
    ) -> Self {
        let sizes = super::sizes(extent, border);
        let trees = sizes.iter().map(|size| (*size, level_sizes(*size).count() as u32));
        let flag = |is: bool| f64::from(u8::from(is));
        let wraps = ("build_wraps", flag(border == Border::Wrap));
        let counting = [wraps, ("build_is_relaxed", flag(cones == Cones::Relaxed))];
        let finest = passes.pass("build_counting", COUNTING, &counting);
        let nodes = passes.pass("build_counting_nodes", COUNTING, &[]);
        let beside = layout(&passes.gpu.device);
        let rounds = [wraps, ("build_rounds", f64::from(ROUNDS))];
        let narrowest = [("build_narrowest", f64::from(RATIO.value(0).to_bits()))];
        Self {
            device: passes.gpu.device.clone(),
            quadtrees: Quadtrees::with(passes, COUNTING, [finest, nodes], trees),
            reached: Reached::new(passes, border, [cones; 4], &narrowest),
            searched: passes.pass_of_parts("build_searched", KNOWN, &rounds, (Some(&beside), 0)),
            codes: passes.pass_of_parts("build_round_cone", format, &narrowest, (Some(&beside), 0)),
            sizes,
            beside,
        }
    }

    /// Draws the cones of a mip that a change may have reached. What that takes besides goes when the device is done.
    pub(in crate::relief::build) fn update(&self, encoder: &mut wgpu::CommandEncoder, ground: &Ground<'_>) {
        let heights = Level { size: self.sizes[ground.mip as usize], ..ground.heights };
        let ground = Ground { heights, ..*ground };
        // Whether a texel counts its neighbours say.
        let texels = around(heights.size, ground.texels, 1);
        let (_, parts) = self.reached.update(encoder, &ground, &self.quadtrees, &texels);
        // New textures are zeros: nothing is steep, and the search is at the root.
        let pair = [0, 1].map(|_| layers(&self.device, KNOWN, heights.size, 1));
        let pair = pair.each_ref().map(|texture| Level::whole(texture, 0));
        let beside = pair.map(|known| self.bind(ground.mip as usize, known));
        let passes = rounds(heights.size).div_ceil(ROUNDS) as usize;
        let whole = Part { behind: heights.size, ..Part::default() };
        for pass in 0..passes {
            let levels = [heights, pair[(pass + 1) % 2]];
            self.searched.draw_parts(encoder, levels, whole, (Some(&beside[pass % 2]), &parts));
        }
        let whole = Part { behind: ground.size, ..Part::default() };
        self.codes.draw_parts(encoder, [heights, ground.image], whole, (Some(&beside[passes % 2]), &parts));
    }

    fn bind(&self, mip: usize, known: Level<'_>) -> wgpu::BindGroup {
        let quadtree = self.quadtrees.texture(mip).create_view(&wgpu::TextureViewDescriptor::default());
        let known = known.view();
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("relief's round cones"),
            layout: &self.beside,
            entries: &[bound(4, &quadtree), bound(5, &known)],
        })
    }
}

const COUNTING: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Uint;
const KNOWN: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Uint;

fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let read = |binding| texture(binding, wgpu::TextureSampleType::Uint, wgpu::TextureViewDimension::D2);
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("relief's round cones"),
        entries: &[read(4), read(5)],
    })
}

/// The most that a search over so many texels takes: the root, and for each node with children four of them and the way back up.
fn rounds(texels: [u32; 2]) -> u32 {
    1 + 5 * level_sizes(texels).skip(1).map(|[width, height]| width * height).sum::<u32>()
}
