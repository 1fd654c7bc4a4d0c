//! A placed map after a part of it has changed.

use super::dirty::{Extent, Region, halved};
use super::{Bounds, Placed, Words, atlas, mips};
use crate::heightfield::{Heights, Texels};

impl Placed {
    /// Brings what depends on a rectangle of changed texels up to date, columns and rows inside the map: it is then as if it
    /// were placed anew. `bounds` are those that it was placed with.
    ///
    /// # Panics
    /// If the map has another size than that which was placed, or is one of floats.
    pub fn update(&mut self, heights: &Heights, bounds: Bounds, texels: &Region) {
        if texels.iter().any(std::ops::Range::is_empty) {
            return;
        }
        let extent = Extent::new(heights);
        assert_eq!(self.heights.size, extent.filled, "a map of another size");
        let width = self.heights.size[0];
        let placed = matches!(bounds, Bounds::None | Bounds::CellMax);
        let (Words::R16(heights_of), true) = (&mut self.heights.words, placed) else {
            // Other bounds reach far beyond what has changed, or are no method's that is meant for changes.
            *self = Self::new(heights, bounds, self.fields[0].limit).expect("a map of floats where steps are placed");
            return;
        };
        let mut changed = extent.texels(texels);
        for region in &changed {
            source(heights, &extent, &mut heights_of[0], width, region);
        }
        for mip in 0..extent.mips {
            if mip > 0 {
                changed = halved(&changed);
                let (finer, coarser) = heights_of.split_at_mut(mip as usize);
                changed.iter().for_each(|region| {
                    mips::halve_part(&finer[mip as usize - 1], &mut coarser[0], width >> mip, region)
                });
            }
            if let (Bounds::CellMax, Words::R16(image)) = (bounds, &mut self.bounds.words) {
                let cells = extent.cells(mip, &changed);
                atlas::update(&mut image[0], extent.filled, mip, &heights_of[mip as usize], cells);
            }
        }
        self.range = range(&heights_of[0]);
    }
}

/// Writes a region of the first mip from the map.
fn source(heights: &Heights, extent: &Extent, texels: &mut [u16], width: u32, [columns, rows]: &Region) {
    for y in rows.clone() {
        for x in columns.clone() {
            let at = extent.source(1, y) * extent.size[0] + extent.source(0, x);
            texels[(y * width + x) as usize] = match heights.texels() {
                Texels::U8(values) => u16::from(values[at as usize]),
                Texels::U16(values) => values[at as usize],
                Texels::F32(_) => panic!("a map of floats where steps are placed"),
            };
        }
    }
}

/// The lowest and the highest.
pub(super) fn range(texels: &[u16]) -> [f64; 2] {
    let (low, high) = texels.iter().fold((u16::MAX, 0), |(low, high), at| (low.min(*at), high.max(*at)));
    [low, high].map(f64::from)
}
