//! Cones over the cells of a map and its mips.
//!
//! ```text
//! heights --Quadtrees--> tips and maxima of them --Table--> of squares --Slopes--> slopes --codes--> a texture
//! ```

mod beside;
mod coarse;
mod round;
mod slopes;
mod table;

use terrane_shaderlib::heightfield::Border;
use terrane_shaderlib::heightfield::cones::{SLOPE, STEEPER, rings};
use terrane_shaderlib::heightfield::pyramid::{Bound, level_sizes};
use terrane_shaderlib::relief::Extent;

use self::beside::Beside;
use self::slopes::Slopes;
use self::table::Tables;
use super::level::Level;
use super::passes::{Pass, Passes};
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
    tables: Tables,
    slopes: Slopes,
    codes: Pass,
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
        let steeper = [("build_steeper", f64::from(STEEPER)), ("build_gentlest", zero), ("build_way", way.into())];
        let layout = Beside::layout(passes.gpu);
        Self {
            wraps,
            tips: Quadtrees::new(passes, wgpu::TextureFormat::R16Uint, Bound::CellMax, trees),
            sizes,
            tables: Tables::new(passes, wraps),
            codes: passes.pass_beside(entry, target, &steeper, Some(&layout)),
            slopes: Slopes::new(passes, layout, ways),
        }
    }

    /// Draws all cones of a mip, since a single texel may narrow any. What that takes besides goes when the device is done.
    pub(super) fn update(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        (image, corner): (Level<'_>, [u32; 2]),
        mip: u32,
        heights: Level<'_>,
    ) {
        let place = (corner, heights.size);
        self.draw(encoder, image, place, (mip, heights));
    }

    /// The same where cones fill a part of so many columns and rows, which may be others than those of the heights.
    fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        image: Level<'_>,
        place: ([u32; 2], [u32; 2]),
        (mip, heights): (u32, Level<'_>),
    ) {
        let heights = Level { size: self.sizes[mip as usize], ..heights };
        let tips = self.tips.redraw(encoder, mip as usize, heights);
        let table = self.tables.room(heights.size);
        table.ground(encoder, heights);
        let slopes = self.slopes.draw(encoder, &table, &tips, &rings(self.wraps, heights.size));
        self.codes.draw_beside_at(encoder, [tips[0], image], &slopes, place);
    }
}

/// Columns and rows of the texels that cones stand on and are narrowed by, mip by mip. Of a map that ends
/// they are its own, as nothing beyond its border counts.
fn sizes(extent: &Extent, border: Border) -> Vec<[u32; 2]> {
    let size = |mip: u32| if border == Border::Wrap { extent.filled.map(|side| side >> mip) } else { extent.size };
    (0..extent.mips).map(size).collect()
}
