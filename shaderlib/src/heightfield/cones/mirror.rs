//! The four quadrants of directions, each as if it were toward larger x and y.

use super::map::Cones;
use crate::heightfield::pyramid::Level;

/// Whether x and y are mirrored.
pub(super) type Mirror = [bool; 2];

/// By their numbers: bit 0 for x, bit 1 for y.
const MIRRORS: [Mirror; 4] = [[false, false], [true, false], [false, true], [true, true]];

/// The quadrants that narrow a cone.
pub(super) fn mirrors(cones: Cones) -> &'static [Mirror] {
    match cones {
        Cones::Quadrant(one) => &MIRRORS[usize::from(one % 4)..][..1],
        _ => &MIRRORS,
    }
}

/// A map whose rows and columns begin at the other end where a mirror says so.
pub(super) fn mirrored(size: [u32; 2], texels: &[f32], mirror: Mirror) -> Level<f32> {
    let row = |y: u32| {
        let y = if mirror[1] { size[1] - 1 - y } else { y };
        &texels[(y * size[0]) as usize..][..size[0] as usize]
    };
    let mut values = Vec::with_capacity(texels.len());
    for y in 0..size[1] {
        match mirror[0] {
            true => values.extend(row(y).iter().rev()),
            false => values.extend(row(y)),
        }
    }
    Level { size, values }
}

/// Where a texel is in a mirrored map.
pub(super) fn place(at: [u32; 2], size: [u32; 2], mirror: Mirror) -> [u32; 2] {
    [0, 1].map(|axis| if mirror[axis] { size[axis] - 1 - at[axis] } else { at[axis] })
}
