//! A placed map after a part of it has changed.

use super::changed::Changed;
use super::cones::update as cones;
use super::dirty::{Extent, Region, halved};
use super::mips::{self, Mip};
use super::{Bounds, MapTexture, Placed, Words, atlas, patches, strip};
use crate::heightfield::pyramid::Bound;
use crate::heightfield::{Heights, Texels};

impl Placed {
    /// Brings what depends on a rectangle of changed texels up to date, columns and rows inside the map: it is then as if it
    /// were placed anew. `bounds` are those that it was placed with. Wide ones keep no maxima: they are found anew, and the nodes over
    /// the rectangle packed from them.
    ///
    /// # Panics
    /// If the map has another size than that which was placed, is one of floats, or was placed with bounds of other texels.
    pub fn update(&mut self, heights: &Heights, bounds: Bounds, texels: &Region) {
        if texels.iter().any(std::ops::Range::is_empty) {
            return;
        }
        let extent = Extent::new(heights);
        let placed = (self.fields[0].last, self.tiled);
        assert_eq!(placed, (extent.last.map(|last| last as i32), extent.is_tiled()), "a map of another size");
        assert!(self.holds(bounds, &extent), "a map placed with other bounds than {bounds:?}");
        let mut after = self.take_mips(&extent);
        let has_cones = matches!(bounds, Bounds::Cones(_) | Bounds::Quadrants | Bounds::Cells);
        let before = if has_cones { after.clone() } else { Vec::new() };
        let texels = change(&mut after, heights, &extent, texels);
        let changed = Changed { heights, extent: &extent, before: &before, after: &after, texels: &texels };
        self.update_bounds(bounds, &changed);
        self.range = range(&after[0].texels);
        match &mut self.heights.words {
            Words::Rg32(images) => all_patches(&mut images[0], &after, &extent, &texels),
            words => *words = Words::R16(after.into_iter().map(|mip| mip.texels).collect()),
        }
    }

    /// Whether it can have been placed with some bounds: those of texels and of cells look alike, and all cones of a word.
    fn holds(&self, bounds: Bounds, extent: &Extent) -> bool {
        let is_as_large = self.bounds.size == MapTexture::Bounds(bounds).size_over(extent);
        is_as_large
            && match bounds {
                Bounds::None | Bounds::CellMax | Bounds::TexelMax => matches!(self.bounds.words, Words::R16(_)),
                Bounds::Patches => matches!(self.bounds.words, Words::R32(_)),
                Bounds::Cones(_) => matches!(self.bounds.words, Words::Rg16(_)),
                Bounds::Quadrants => matches!(self.bounds.words, Words::Rg32(_)),
                Bounds::Cells | Bounds::Wide => matches!(self.bounds.words, Words::Rgba32(_)),
            }
    }

    /// The heights of all mips. Those that are no patches are gone from here.
    fn take_mips(&mut self, extent: &Extent) -> Vec<Mip> {
        match &mut self.heights.words {
            Words::R16(images) => {
                let sizes = (0..).map(|mip| extent.filled.map(|side| side >> mip));
                let images = std::mem::take(images).into_iter();
                images.zip(sizes).map(|(texels, size)| Mip { size, texels }).collect()
            }
            Words::Rg32(images) => patches::mips(&images[0], extent.filled, extent.mips),
            _ => unreachable!("heights are texels or patches"),
        }
    }

    fn update_bounds(&mut self, bounds: Bounds, change: &Changed<'_>) {
        match (bounds, &mut self.bounds.words) {
            (Bounds::CellMax, Words::R16(images)) => quadtrees(&mut images[0], Bound::CellMax, change),
            (Bounds::TexelMax, Words::R16(images)) => quadtrees(&mut images[0], Bound::TexelMax, change),
            (Bounds::Patches, Words::R32(image)) => quadtrees(image, Bound::CellMax, change),
            (Bounds::Cones(kind), Words::Rg16(images)) => cones::plane(images, kind, change),
            (Bounds::Quadrants, Words::Rg32(images)) => cones::quadrants(images, change),
            (Bounds::Cells, Words::Rgba32(image)) => cones::cells(image, change),
            (Bounds::Wide, Words::Rgba32(image)) => strip::update(image, change),
            // None: what it holds has been asked.
            _ => (),
        }
    }
}

/// Brings mips up to date, and tells which of their texels may be others.
fn change(all: &mut [Mip], heights: &Heights, extent: &Extent, texels: &Region) -> Vec<Vec<Region>> {
    let mut changed = vec![extent.texels(texels)];
    changed[0].iter().for_each(|region| source(heights, extent, &mut all[0], region));
    for mip in 1..all.len() {
        let regions = halved(&changed[mip - 1]);
        let (finer, coarser) = all.split_at_mut(mip);
        let width = coarser[0].size[0];
        regions.iter().for_each(|region| {
            mips::halve_part(&finer[mip - 1].texels, &mut coarser[0].texels, width, region);
        });
        changed.push(regions);
    }
    changed
}

/// Writes a region of the first mip from the map.
fn source(heights: &Heights, extent: &Extent, mip: &mut Mip, [columns, rows]: &Region) {
    for y in rows.clone() {
        for x in columns.clone() {
            let at = (extent.source(1, y) * extent.size[0] + extent.source(0, x)) as usize;
            mip.texels[(y * mip.size[0] + x) as usize] = match heights.texels() {
                Texels::U8(values) => u16::from(values[at]),
                Texels::U16(values) => values[at],
                Texels::F32(_) => panic!("a map of floats where steps are placed"),
            };
        }
    }
}

fn quadtrees<T: Copy + Ord + From<u16>>(image: &mut [T], bound: Bound, change: &Changed<'_>) {
    for ((index, mip), texels) in (0..).zip(change.after).zip(change.texels) {
        let nodes = if bound == Bound::TexelMax { texels.clone() } else { change.extent.cells(index, texels) };
        atlas::update(image, change.extent.filled, (index, mip), bound, nodes);
    }
}

fn all_patches(image: &mut [[u32; 2]], mips: &[Mip], extent: &Extent, texels: &[Vec<Region>]) {
    for ((index, mip), texels) in (0..).zip(mips).zip(texels) {
        for cells in extent.cells(index, texels) {
            let set = |texel: &mut [u32; 2], patch| *texel = patch;
            patches::write(image, extent.filled[0], extent.patches(index), (mip, extent.wraps), &cells, set);
        }
    }
}

/// The lowest and the highest.
pub(super) fn range(texels: &[u16]) -> [f64; 2] {
    let (low, high) = texels.iter().fold((u16::MAX, 0), |(low, high), at| (low.min(*at), high.max(*at)));
    [low, high].map(f64::from)
}
