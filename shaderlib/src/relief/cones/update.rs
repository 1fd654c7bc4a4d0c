//! Cones and their tips after a part of a map has changed.

use super::super::changed::Changed;
use super::super::dirty::{Region, inside};
use super::super::{coarse, patches};
use super::{own, tip, twelve};
use crate::heightfield::Heights;
use crate::heightfield::cones::{Cones, Part, Stored, changed, each, standing};

/// What cones of a map stand on, before and after.
struct Ground {
    maps: [Heights; 2],
    texels: Vec<Region>,
}

/// A part of an image: where its first texel is, in how many columns and rows of how long rows.
struct View {
    row: usize,
    corner: [usize; 2],
    size: [u32; 2],
}

impl Ground {
    fn of(change: &Changed<'_>, mip: usize) -> Self {
        let maps = [&change.before[mip], &change.after[mip]].map(|mip| own(change.heights, mip));
        let size = maps[1].size();
        let texels = change.texels[mip].iter().filter_map(|texels| inside(texels, size)).collect();
        Self { texels, maps }
    }

    /// Of coarse nodes.
    fn coarse(change: &Changed<'_>, mip: usize) -> Self {
        let border = change.heights.border();
        let maps = [&change.before[mip], &change.after[mip]].map(|mip| coarse::heights(mip, border));
        let cells = change.extent.cells(mip as u32, &change.texels[mip]);
        Self { texels: coarse::texels(&cells, maps[1].size(), border), maps }
    }

    fn changed(
        &self,
        stored: &Stored,
        is_reached: &(impl Fn([usize; 2], u16) -> bool + Sync),
    ) -> Vec<(Part, Vec<u16>)> {
        if self.texels.is_empty() {
            return Vec::new();
        }
        changed(stored, (&self.maps[0], &self.maps[1]), &self.texels, is_reached)
    }
}

/// Brings the tips and codes of one kind of cones up to date.
pub(in crate::relief) fn plane(images: &mut [Vec<[u16; 2]>], cones: Cones, change: &Changed<'_>) {
    let stored = Stored { cones, unit: 1.0 };
    for (mip, image) in images.iter_mut().enumerate() {
        let view = View::of(change.after[mip].size);
        let reached = |at, code| stored.is_as_steep(code, image[view.at(at)][1]);
        let ground = Ground::of(change, mip);
        for (part, codes) in ground.changed(&stored, &reached) {
            each(&part, standing(&ground.maps[1], cones), view.size, &codes, |at, cell, code| {
                image[view.at(at)] = [tip(&ground.maps[1], cones, cell), code];
            });
        }
    }
}

/// The same for the cones of the four quadrants.
pub(in crate::relief) fn quadrants(images: &mut [Vec<[u32; 2]>], change: &Changed<'_>) {
    for (mip, image) in images.iter_mut().enumerate() {
        toward_all(image, &View::of(change.after[mip].size), &Ground::of(change, mip));
    }
}

/// The same where patches are beside them, and coarse nodes under them.
pub(in crate::relief) fn cells(image: &mut [[u32; 4]], change: &Changed<'_>) {
    let map = change.extent.filled;
    let view = |corner: [u32; 2], size| View { row: map[0] as usize, corner: corner.map(|at| at as usize), size };
    for (mip, after) in change.after.iter().enumerate() {
        let corner = change.extent.patches(mip as u32);
        toward_all(image, &view(corner, after.size), &Ground::of(change, mip));
        if let Some(corner) = change.extent.coarse(mip as u32) {
            toward_all(image, &view(corner, coarse::nodes(after.size)), &Ground::coarse(change, mip));
        }
        for cells in change.extent.cells(mip as u32, &change.texels[mip]) {
            patches::write(image, map[0], corner, (after, change.extent.wraps), &cells, |texel, patch| {
                texel[2..].copy_from_slice(&patch);
            });
        }
    }
}

/// Words as [`packed`](super::packed()) has them, by quadrant.
fn toward_all<const N: usize>(image: &mut [[u32; N]], view: &View, ground: &Ground) {
    for quadrant in 0..4 {
        let (word, shift) = (usize::from(quadrant / 2), 12 * (quadrant % 2));
        let stored = Stored { cones: Cones::Quadrant(quadrant), unit: 1.0 };
        let reached = |at, code| code > 0 && twelve(code) >= image[view.at(at)][word] >> shift & 0xfff;
        for (part, codes) in ground.changed(&stored, &reached) {
            each(&part, standing(&ground.maps[1], stored.cones), view.size, &codes, |at, cell, code| {
                let texel = &mut image[view.at(at)];
                texel[word] = texel[word] & !(0xfff << shift) | twelve(code) << shift;
                let tip = u32::from(tip(&ground.maps[1], stored.cones, cell));
                [texel[0], texel[1]] = [texel[0] & 0xff_ffff | tip << 24, texel[1] & 0xff_ffff | tip >> 8 << 24];
            });
        }
    }
}

impl View {
    /// All of an image.
    fn of(size: [u32; 2]) -> Self {
        Self { row: size[0] as usize, corner: [0; 2], size }
    }

    fn at(&self, [x, y]: [usize; 2]) -> usize {
        (self.corner[1] + y) * self.row + self.corner[0] + x
    }
}
