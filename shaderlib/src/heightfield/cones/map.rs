//! A cone for every texel.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use super::change::changed;
use super::part::{Part, bands, codes, each, standing, turns};
use super::stored::Stored;
use crate::heightfield::{Heights, Texels};

/// Which cones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cones {
    /// Round, over texels: no texel reaches into the cone. The bilinear surface between them may. Source: Dummer, "Cone Step
    /// Mapping: An Iterative Ray-Heightfield Intersection Algorithm", 2006.
    Step,
    /// Round, over texels: a ray that falls may pierce the ground in the cone, but does not come out again. Source: Policarpo
    /// and Oliveira, "Relaxed Cone Stepping for Relief Mapping", GPU Gems 3, 2007, chapter 18; which texels narrow the cone
    /// after Bán, Valasek, Bálint and Vad, "Robust Cone Step Mapping", EGSR 2024.
    Relaxed,
    /// Square, over cells: from any point over a cell above its highest corner, the cone from there down to that height is free
    /// of the bilinear surface. After Bán, Valasek, Bálint and Vad, "Robust Cone Step Mapping", EGSR 2024, whose cones are
    /// round, stand on texels and are narrowed to the smallest of nine neighbours; the tip over a whole cell does the same.
    Robust,
    /// The same for rays toward one quadrant alone, which narrow it less: bit 0 of its number is set toward smaller x, bit 1
    /// toward smaller y.
    Quadrant(u8),
}

impl Cones {
    /// Whether they are square and stand on cells.
    pub(super) fn are_square(self) -> bool {
        matches!(self, Self::Robust | Self::Quadrant(_))
    }
}

/// The heights of texels in steps of the map.
pub(super) fn steps(texels: &Texels) -> Vec<f32> {
    match texels {
        Texels::U8(values) => values.iter().map(|value| f32::from(*value)).collect(),
        Texels::U16(values) => values.iter().map(|value| f32::from(*value)).collect(),
        Texels::F32(values) => values.clone(),
    }
}

/// The cones of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct ConeMap {
    /// Which.
    pub cones: Cones,
    /// Columns and rows: one for each texel. The last ones of a clamped map, where no cell begins, repeat those before.
    pub size: [u32; 2],
    /// Steps of the map to a unit of height: 1 for 8- and 16-bit maps; for floats the power of two that makes at most 65536 units
    /// of the whole range.
    pub unit: f64,
    /// In [`RATIO`](super::RATIO) or [`SLOPE`](super::SLOPE), row by row.
    pub codes: Vec<u16>,
}

impl ConeMap {
    /// Builds it on all cores. `progress` is told, from any of them, how much is done and how much there is.
    #[must_use]
    pub fn new(heights: &Heights, cones: Cones, progress: &(dyn Fn(u64, u64) + Sync)) -> Self {
        let stored = Stored { cones, unit: unit(heights.texels()) };
        let parts = bands(heights, cones);
        let (total, finished) = (turns(cones) * parts.len() as u64, AtomicU64::new(0));
        let done = || progress(finished.fetch_add(1, Ordering::Relaxed) + 1, total);
        let codes = codes(heights, &stored, &parts, &done);
        let size = heights.size();
        let mut map = Self { cones, size, unit: stored.unit, codes: vec![0; size[0] as usize * size[1] as usize] };
        map.place(standing(heights, cones), parts.into_iter().zip(codes));
        map
    }

    /// Brings what a rectangle of changed texels may have reached up to date, columns and rows inside the map: of a map `before` it
    /// changed and `after`. It is then as if it were built anew. A cone is found again where what has changed is, or was, as steep
    /// from there as the cone: near by, and where nothing else is steeper.
    ///
    /// # Panics
    /// If the maps differ in size, border or kind of texels, or have not the size of this one.
    pub fn update(&mut self, before: &Heights, after: &Heights, texels: &[Range<u32>; 2]) {
        let kind = |map: &Heights| (map.size(), map.border(), std::mem::discriminant(map.texels()));
        assert_eq!((before.size(), kind(before)), (self.size, kind(after)), "cones of another map");
        if texels.iter().any(Range::is_empty) {
            return;
        }
        let stored = Stored { cones: self.cones, unit: self.unit };
        if unit(after.texels()) != self.unit {
            *self = Self::new(after, self.cones, &|_, _| ());
            return;
        }
        let width = self.size[0] as usize;
        let is_reached = |[x, y]: [usize; 2], code: u16| stored.is_as_steep(code, self.codes[y * width + x]);
        let changed = changed(&stored, (before, after), std::slice::from_ref(texels), &is_reached);
        self.place(standing(after, self.cones), changed);
    }

    /// Takes the codes of some parts.
    fn place(&mut self, standing: [usize; 2], parts: impl IntoIterator<Item = (Part, Vec<u16>)>) {
        let width = self.size[0] as usize;
        for (part, codes) in parts {
            each(&part, standing, self.size, &codes, |[x, y], _, code| self.codes[y * width + x] = code);
        }
    }

    /// Steps for each texel that a cone is steep: what the shader decodes, exactly.
    ///
    /// # Panics
    /// If there is no such texel.
    #[must_use]
    pub fn slope(&self, x: u32, y: u32) -> f64 {
        let code = self.codes[y as usize * self.size[0] as usize + x as usize];
        Stored { cones: self.cones, unit: self.unit }.slope(code)
    }

    /// Bytes of the codes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(&self.codes[..])
    }
}

fn unit(texels: &Texels) -> f64 {
    let Texels::F32(values) = texels else { return 1.0 };
    let [low, high] = values
        .iter()
        .fold([f64::MAX, f64::MIN], |[low, high], value| [low.min(f64::from(*value)), high.max(f64::from(*value))]);
    if high > low { ((high - low) / 65536.0).log2().ceil().exp2() } else { 1.0 }
}
