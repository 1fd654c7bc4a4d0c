//! A height map and its quadtree in textures.

use std::fmt;

use terrane_shaderlib::heightfield::pyramid::{Bound, Levels, Pyramid};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};

/// What a device needs of a map: texels, bounds, and how they are read.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Columns and rows of the finest level, powers of two.
    pub(super) size: [u32; 2],
    /// The heights, filled up with those of the border.
    pub(super) texels: Vec<u16>,
    /// The maxima, level by level, filled up likewise: a ray that ends on the border may stand in the cell behind it.
    pub(super) bounds: Vec<Vec<u16>>,
    /// `ReliefField::wrap`.
    pub(super) wrap: [i32; 2],
    /// `ReliefField::last`.
    pub(super) last: [i32; 2],
    /// The lowest and the highest height.
    pub(super) range: [f64; 2],
}

/// Why a map cannot be traced on a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unplaceable {
    /// Its heights are floats; shaders read 16-bit steps.
    Floats,
    /// It wraps and a side is no power of two.
    Wrap([u32; 2]),
}

impl fmt::Display for Unplaceable {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Floats => to.write_str("a map of floats: shaders read steps, quantise it to 16 bits"),
            Self::Wrap([width, height]) => {
                write!(to, "a map that wraps and has {width} x {height} texels: sides must be powers of two")
            }
        }
    }
}

impl std::error::Error for Unplaceable {}

impl Placed {
    /// Builds the quadtree and fills everything up to powers of two.
    ///
    /// # Errors
    /// Those of [`Unplaceable`].
    pub fn new(heights: &Heights) -> Result<Self, Unplaceable> {
        let texels: Vec<u16> = match heights.texels() {
            Texels::U8(values) => values.iter().map(|value| u16::from(*value)).collect(),
            Texels::U16(values) => values.clone(),
            Texels::F32(_) => return Err(Unplaceable::Floats),
        };
        let size = heights.size();
        let wraps = heights.border() == Border::Wrap;
        if wraps && !size.iter().all(|side| side.is_power_of_two()) {
            return Err(Unplaceable::Wrap(size));
        }
        let filled = size.map(u32::next_power_of_two);
        let wrap = if wraps { filled.map(|side| side as i32 - 1) } else { [-1; 2] };
        let texels = fill(&texels, size, filled);
        // Filled up it wraps, whatever it did: the nodes behind the border are held against the first column as well, which
        // bounds them all the same.
        let whole = Heights::new(filled, Border::Wrap, Texels::U16(texels.clone()))
            .expect("a power of two is in range where no smaller side was beyond it");
        let Levels::U16(levels) = Pyramid::new(&whole, Bound::CellMax).levels().clone() else {
            return Err(Unplaceable::Floats);
        };
        let bounds = levels.into_iter().map(|level| level.values).collect();
        let range = texels
            .iter()
            .fold([f64::MAX, 0.0], |[low, high], height| [low.min(f64::from(*height)), high.max(f64::from(*height))]);
        let last = size.map(|side| side as i32 - 1);
        Ok(Self { size: filled, texels, bounds, wrap, last, range })
    }
}

/// The last column and the last row again, as often as it takes.
fn fill(values: &[u16], size: [u32; 2], wanted: [u32; 2]) -> Vec<u16> {
    let [width, height] = size.map(|side| side as usize);
    let rows = (0..wanted[1] as usize).map(|y| &values[y.min(height - 1) * width..][..width]);
    rows.flat_map(|row| (0..wanted[0] as usize).map(move |x| row[x.min(width - 1)])).collect()
}
