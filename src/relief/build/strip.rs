//! Wide nodes of all mips: a strip of them, broken into the rows of a texture.

use terrane_shaderlib::heightfield::pyramid::CHILDREN;
use terrane_shaderlib::relief::{Extent, Region, halved, wide_places};

use super::level::Level;
use super::passes::{Part, Pass, Passes};
use super::quadtrees::Drawn;

/// What draws them.
#[derive(Debug)]
pub(super) struct Strip {
    pass: Pass,
    /// Where the nodes of each level of each mip begin.
    places: Vec<Vec<usize>>,
}

impl Strip {
    /// The one of a map.
    pub(super) fn new(passes: &Passes<'_>, format: wgpu::TextureFormat, extent: &Extent) -> Self {
        Self { pass: passes.pass("build_wide", format, &[]), places: wide_places(extent) }
    }

    /// Draws the nodes of a mip over what has been drawn of its quadtree: those of a level are over every second one there.
    pub(super) fn update(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        image: Level<'_>,
        mip: u32,
        quadtree: &[Drawn<'_>],
    ) {
        for (place, (children, regions)) in self.places[mip as usize].iter().zip(quadtree.iter().step_by(2)) {
            let place = *place as u32;
            let columns = children.size[0].div_ceil(CHILDREN);
            for nodes in halved(&halved(regions)) {
                let part = Part {
                    corner: [place, image.size[0]],
                    first: nodes.each_ref().map(|range| range.start),
                    behind: nodes.each_ref().map(|range| range.end),
                };
                self.pass.draw_part(encoder, [*children, image], part, &[rows(&nodes, place, columns, image.size[0])]);
            }
        }
    }
}

/// The rows of the texture that have such nodes of a level of so many columns.
fn rows([x, y]: &Region, place: u32, columns: u32, width: u32) -> Region {
    let first = place + y.start * columns + x.start;
    let last = place + (y.end - 1) * columns + x.end - 1;
    [0..width, first / width..last / width + 1]
}
