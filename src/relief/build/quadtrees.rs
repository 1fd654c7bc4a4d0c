//! Pyramids of two by two nodes to one of the next level.

use terrane_shaderlib::heightfield::pyramid::{Bound, level_sizes};
use terrane_shaderlib::relief::{Region, halved};

use super::level::{Level, texture};
use super::passes::{Pass, Passes};

/// Those of one bound over one map or over each of its mips.
#[derive(Debug)]
pub(super) struct Quadtrees {
    pub(super) bound: Bound,
    finest: Pass,
    nodes: Pass,
    trees: Vec<Quadtree>,
}

/// Level k stands in the first columns and rows of mip k.
#[derive(Debug)]
struct Quadtree {
    texture: wgpu::Texture,
    sizes: Vec<[u32; 2]>,
}

/// A level, and which of its nodes have been drawn.
pub(super) type Drawn<'t> = (Level<'t>, Vec<Region>);

impl Quadtrees {
    /// Room for pyramids of so many levels over finest ones of so many columns and rows. The format of floats is that of their
    /// bits.
    pub(super) fn new(
        passes: &Passes<'_>,
        format: wgpu::TextureFormat,
        bound: Bound,
        trees: impl Iterator<Item = ([u32; 2], u32)>,
    ) -> Self {
        let flag = |is: bool| f64::from(u8::from(is));
        let constants = [
            ("build_is_lowest", flag(bound == Bound::CellMin)),
            ("build_is_float", flag(format == wgpu::TextureFormat::R32Uint)),
        ];
        let (entry, with) =
            if bound == Bound::TexelMax { ("build_same", &[][..]) } else { ("build_cells", &constants[..]) };
        let finest = passes.pass(entry, format, with);
        let nodes = passes.pass("build_nodes", format, &constants);
        Self { bound, ..Self::with(passes, format, [finest, nodes], trees) }
    }

    /// The same for passes of their own: over texels, and over nodes.
    pub(super) fn with(
        passes: &Passes<'_>,
        format: wgpu::TextureFormat,
        [finest, nodes]: [Pass; 2],
        trees: impl Iterator<Item = ([u32; 2], u32)>,
    ) -> Self {
        let tree = |(finest, levels): ([u32; 2], u32)| Quadtree {
            texture: texture(
                passes.gpu,
                format,
                finest.map(u32::next_power_of_two),
                levels,
                wgpu::TextureUsages::empty(),
            ),
            sizes: level_sizes(finest).take(levels as usize).collect(),
        };
        Self { bound: Bound::TexelMax, finest, nodes, trees: trees.map(tree).collect() }
    }

    /// The texture of a pyramid.
    pub(super) fn texture(&self, index: usize) -> &wgpu::Texture {
        &self.trees[index].texture
    }

    /// The levels of a pyramid.
    pub(super) fn levels(&self, index: usize) -> impl Iterator<Item = Level<'_>> {
        let Quadtree { texture, sizes } = &self.trees[index];
        sizes.iter().enumerate().map(|(mip, size)| Level { texture, mip: mip as u32, layer: 0, size: *size })
    }

    /// Draws some nodes of the finest level of a pyramid from the heights under it, and all nodes over them.
    pub(super) fn update<'t>(
        &'t self,
        encoder: &mut wgpu::CommandEncoder,
        index: usize,
        heights: Level<'_>,
        nodes: &[Region],
    ) -> Vec<Drawn<'t>> {
        let mut drawn: Vec<Drawn<'t>> = Vec::new();
        for level in self.levels(index) {
            let regions = match drawn.last() {
                None => {
                    self.finest.draw(encoder, heights, level, nodes);
                    nodes.to_vec()
                }
                Some((finer, children)) => {
                    let parents = halved(children);
                    self.nodes.draw(encoder, *finer, level, &parents);
                    parents
                }
            };
            drawn.push((level, regions));
        }
        drawn
    }
}
