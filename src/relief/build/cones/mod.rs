//! Cones over the cells of a map and its mips.
//!
//! ```text
//! heights --Quadtrees--> tips and maxima of them --Table--> of squares --Slopes--> slopes --codes--> a texture
//!                        tips and a texture as it was --Reached--> which parts of it are drawn
//! ```

mod beside;
mod coarse;
mod reached;
mod round;
mod slopes;
mod table;

use terrane_shaderlib::heightfield::Border;
use terrane_shaderlib::heightfield::cones::{Cones, SLOPE, STEEPER, rings};
use terrane_shaderlib::heightfield::pyramid::{Bound, level_sizes};
use terrane_shaderlib::relief::{Extent, Region, around};

use self::beside::Beside;
use self::reached::Reached;
use self::slopes::Slopes;
use self::table::Tables;
use super::level::Level;
use super::passes::{Part, Pass, Passes};
use super::quadtrees::Quadtrees;

pub(super) use self::coarse::Coarse;
pub(super) use self::round::Rounds;

/// What draws them.
#[derive(Debug)]
pub(super) struct Squares {
    wraps: bool,
    /// Columns and rows of texels, mip by mip.
    sizes: Vec<[u32; 2]>,
    tips: Quadtrees,
    reached: Reached,
    tables: Tables,
    slopes: Slopes,
    codes: Pass,
}

/// What cones stand on, and where they are drawn.
#[derive(Clone, Copy)]
pub(super) struct Ground<'t> {
    pub(super) mip: u32,
    pub(super) heights: Level<'t>,
    /// Texels of these that may be others.
    pub(super) texels: &'t [Region],
    /// Where cones are drawn: from a corner on, in so many columns and rows.
    pub(super) image: Level<'t>,
    pub(super) corner: [u32; 2],
    pub(super) size: [u32; 2],
}

/// Which slopes are kept of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ways {
    /// The steepest.
    All,
    /// Those toward the four quadrants.
    Quadrants,
    /// The one toward a quadrant, by its number.
    Quadrant(u8),
}

impl Squares {
    /// Those of a map.
    pub(super) fn new(
        passes: &Passes<'_>,
        target: impl Into<wgpu::ColorTargetState>,
        (extent, border): (&Extent, Border),
        ways: Ways,
    ) -> Self {
        Self::over(passes, target, (sizes(extent, border), border), ways)
    }

    /// Those of texels in so many columns and rows, mip by mip.
    pub(super) fn over(
        passes: &Passes<'_>,
        target: impl Into<wgpu::ColorTargetState>,
        (sizes, border): (Vec<[u32; 2]>, Border),
        ways: Ways,
    ) -> Self {
        let wraps = border == Border::Wrap;
        let trees = sizes.iter().map(|size| border.cells(*size));
        let trees = trees.map(|finest| (finest, level_sizes(finest).count() as u32));
        let zero = f64::from(SLOPE.value(0).to_bits());
        let (entry, way) = match ways {
            Ways::All => ("build_cone", 0),
            Ways::Quadrant(number) => ("build_cone", number % 4),
            Ways::Quadrants => ("build_quadrants", 0),
        };
        let cones = match ways {
            Ways::All => [Cones::Robust; 4],
            Ways::Quadrant(number) => [Cones::Quadrant(number); 4],
            Ways::Quadrants => [0, 1, 2, 3].map(Cones::Quadrant),
        };
        let steeper = [("build_steeper", f64::from(STEEPER)), ("build_gentlest", zero), ("build_way", way.into())];
        let layout = Beside::layout(passes.gpu);
        Self {
            wraps,
            tips: Quadtrees::new(passes, wgpu::TextureFormat::R16Uint, Bound::CellMax, trees),
            sizes,
            tables: Tables::new(passes, wraps),
            reached: Reached::new(passes, border, cones, &steeper),
            codes: passes.pass_of_parts(entry, target, &steeper, (Some(&layout), 0)),
            slopes: Slopes::new(passes, layout, ways),
        }
    }

    /// Draws the cones of a mip that a change may have reached. What that takes besides goes when the device is done.
    pub(super) fn update(&self, encoder: &mut wgpu::CommandEncoder, ground: &Ground<'_>) {
        let heights = Level { size: self.sizes[ground.mip as usize], ..ground.heights };
        let ground = Ground { heights, ..*ground };
        let cells = around(heights.size, ground.texels, 0);
        let (tips, parts) = self.reached.update(encoder, &ground, &self.tips, &cells);
        let table = self.tables.room(heights.size, &parts);
        table.ground(encoder, heights);
        let slopes = self.slopes.draw(encoder, &table, &tips, &rings(self.wraps, heights.size));
        let part = Part { corner: ground.corner, behind: ground.size, ..Part::default() };
        self.codes.draw_parts(encoder, [tips[0], ground.image], part, (Some(&slopes), &parts));
    }
}

/// Columns and rows of the texels that cones stand on and are narrowed by, mip by mip. Of a map that ends
/// they are its own, as nothing beyond its border counts.
fn sizes(extent: &Extent, border: Border) -> Vec<[u32; 2]> {
    let size = |mip: u32| if border == Border::Wrap { extent.filled.map(|side| side >> mip) } else { extent.size };
    (0..extent.mips).map(size).collect()
}
