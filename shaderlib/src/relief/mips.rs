//! Coarser forms of a map of heights.

use super::dirty::Region;
use crate::heightfield::pyramid::{Bound, Level, Levels, Pyramid};
use crate::heightfield::{Border, Heights, Texels};

/// One mip of a map, filled up to powers of two.
#[derive(Clone)]
pub(super) struct Mip {
    pub(super) size: [u32; 2],
    pub(super) texels: Vec<u16>,
}

impl Mip {
    /// As a map that wraps.
    pub(super) fn heights(&self) -> Heights {
        Heights::new(self.size, Border::Wrap, Texels::U16(self.texels.clone()))
            .expect("a power of two is in range where no smaller side was beyond it")
    }

    /// Its quadtree. Filled up a map wraps, whatever it did: the nodes behind the border are held against the first column as well,
    /// which bounds them all the same.
    pub(super) fn quadtree(&self, bound: Bound) -> Vec<Level<u16>> {
        match Pyramid::new(&self.heights(), bound).into_levels() {
            Levels::U16(levels) => levels,
            Levels::U8(_) | Levels::F32(_) => unreachable!("a pyramid has the texels of its map"),
        }
    }
}

/// The map and its mips; one that ends at its border has none.
pub(super) fn all(texels: Vec<u16>, size: [u32; 2], wraps: bool) -> Vec<Mip> {
    let mut mips = vec![Mip { size, texels }];
    let steps = if wraps { size[0].min(size[1]).ilog2() } else { 0 };
    for _ in 0..steps {
        let finer = &mips[mips.len() - 1];
        let coarser = Mip { size: finer.size.map(|side| side / 2), texels: halve(&finer.texels, finer.size) };
        mips.push(coarser);
    }
    mips
}

/// A texel of the next mip is the mean of the four that it covers, rounded; a side of 1 stays. Sides are powers of two.
pub(super) fn halve(texels: &[u16], [width, height]: [u32; 2]) -> Vec<u16> {
    let (columns, rows) = (width.div_ceil(2), height.div_ceil(2));
    let at = |x: u32, y: u32| u32::from(texels[(y.min(height - 1) * width + x.min(width - 1)) as usize]);
    let mean = |x: u32, y: u32| {
        let sum = at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) + at(2 * x + 1, 2 * y + 1);
        // At most 65535 again.
        ((sum + 2) / 4) as u16
    };
    (0..rows).flat_map(|y| (0..columns).map(move |x| mean(x, y))).collect()
}

/// A region of the next mip, of so many columns. Both sides of the finer one are twice as long.
pub(super) fn halve_part(finer: &[u16], coarser: &mut [u16], width: u32, [columns, rows]: &Region) {
    for y in rows.clone() {
        for x in columns.clone() {
            let at = |i: u32, j: u32| u32::from(finer[((2 * y + j) * 2 * width + 2 * x + i) as usize]);
            let sum = at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1);
            coarser[(y * width + x) as usize] = ((sum + 2) / 4) as u16;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_rounded_and_long_maps_keep_their_short_side() {
        assert_eq!(halve(&[0, 1, 1, 1], [2, 2]), [1]);
        assert_eq!(halve(&[65535; 4], [2, 2]), [65535]);
        assert_eq!(halve(&[2, 4, 10, 20], [4, 1]), [3, 15]);
    }
}
