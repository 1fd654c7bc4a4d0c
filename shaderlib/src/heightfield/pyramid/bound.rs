//! What a pyramid says of the surface.

use std::ops::Range;

use super::level::Region;
use crate::heightfield::heights::{Border, Heights};

/// What the finest level bounds, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// The largest texel of a node. Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro 1, 2010,
    /// section 1.4.1. No bound of the bilinear surface: that leaves a texel's square through the neighbours' heights.
    TexelMax,
    /// The largest height of the surface. Source: Tevs, Ihrke and Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable
    /// Dynamic Height Field Rendering", I3D 2008, section 3: level 0 is the largest of a cell's four corners.
    CellMax,
    /// The smallest height of the surface, for materials that hide each other.
    CellMin,
}

impl Bound {
    /// Columns and rows of the finest level over a map: its texels, or its cells.
    #[must_use]
    pub fn nodes(self, heights: &Heights) -> [u32; 2] {
        match self {
            Self::TexelMax => heights.size(),
            Self::CellMax | Self::CellMin => heights.cells(),
        }
    }

    /// The nodes of the finest level that depend on a rectangle of texels, columns and rows inside the map.
    #[must_use]
    pub fn touched(self, heights: &Heights, texels: [Range<u32>; 2]) -> Vec<[Range<u32>; 2]> {
        match self {
            Self::TexelMax => vec![texels],
            Self::CellMax | Self::CellMin => cells(texels, heights.cells(), heights.border() == Border::Wrap),
        }
    }
}

/// The regions of cells that touch a rectangle of texels, `first..end` on each axis: one more to the left and above, which
/// a wrapped map has at the far end.
fn cells(texels: Region, cells: [u32; 2], wrap: bool) -> Vec<Region> {
    let [columns, rows] = [0, 1].map(|axis| {
        let (first, end) = (texels[axis].start, texels[axis].end.min(cells[axis]));
        let near = first.saturating_sub(1).min(cells[axis] - 1)..end.max(1);
        let far = (first == 0 && wrap).then(|| cells[axis] - 1..cells[axis]);
        [Some(near), far].into_iter().flatten().collect::<Vec<_>>()
    });
    let pairs = columns.iter().flat_map(|x| rows.iter().map(move |y| [x.clone(), y.clone()]));
    pairs.collect()
}
