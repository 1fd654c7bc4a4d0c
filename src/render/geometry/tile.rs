//! The land around the terrain: mirror images of it, so that no picture shows where the height map ends.

use glam::DVec3;

use crate::render::height_field::HeightField;

/// A copy of the terrain. Every second copy on an axis is mirrored, so that all meet at equal heights; copy 0 is the
/// terrain itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Tile(pub [i32; 2]);

impl Tile {
    /// The terrain itself.
    pub const MIDDLE: Self = Self([0, 0]);

    /// The copies up to `rings` away, row by row.
    pub fn around(rings: u32) -> impl Iterator<Item = Self> {
        let side = 2 * rings as i32 + 1;
        (0..side * side).map(move |i| Self([i % side - rings as i32, i / side - rings as i32]))
    }

    /// 1, or -1 where the copy is mirrored, on x and z.
    #[must_use]
    pub fn mirror(self) -> [i32; 2] {
        self.0.map(|place| 1 - 2 * place.rem_euclid(2))
    }

    /// Where a texel of the height map lies in the row of copies, in texels from the terrain's first.
    #[must_use]
    pub fn unfold(self, field: &HeightField, texel: [i32; 2]) -> [i32; 2] {
        [0, 1].map(|axis| {
            let (place, period) = (self.0[axis], field.size()[axis] as i32 - 1);
            if place.rem_euclid(2) == 0 { place * period + texel[axis] } else { (place + 1) * period - texel[axis] }
        })
    }

    /// A texel's x and z in metres.
    #[must_use]
    pub fn metres(self, field: &HeightField, texel: [i32; 2]) -> [f64; 2] {
        let unfolded = self.unfold(field, texel);
        [0, 1].map(|axis| (f64::from(unfolded[axis]) + 0.5) * field.spacing()[axis])
    }

    /// Low and high corner of a box over texels.
    #[must_use]
    pub(super) fn bounding_box(self, field: &HeightField, texels: [[i32; 2]; 2], heights: [f32; 2]) -> [DVec3; 2] {
        let [a, b] = texels.map(|texel| self.metres(field, texel));
        let corner = |x, height, z| DVec3::new(x, f64::from(height), z);
        [corner(a[0].min(b[0]), heights[0], a[1].min(b[1])), corner(a[0].max(b[0]), heights[1], a[1].max(b[1]))]
    }
}
