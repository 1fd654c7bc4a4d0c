//! The height map that a relief is made of.

use std::fmt;

/// Largest side of a map: what core WebGPU promises for a texture.
pub const LARGEST_SIDE: u32 = 8192;

/// What lies beyond the border.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Border {
    /// The map again: it tiles.
    Wrap,
    /// Nothing: the surface ends at the centres of the outermost texels.
    Clamp,
}

impl Border {
    /// Columns and rows of cells over so many texels.
    #[must_use]
    pub fn cells(self, texels: [u32; 2]) -> [u32; 2] {
        match self {
            Self::Wrap => texels,
            Self::Clamp => texels.map(|side| side.saturating_sub(1).max(1)),
        }
    }
}

/// The heights as they were measured. Traversal counts in their own unit: 1 is one step of an 8- or 16-bit map.
#[derive(Clone, Debug, PartialEq)]
pub enum Texels {
    /// 0..255.
    U8(Vec<u8>),
    /// 0..65535.
    U16(Vec<u16>),
    /// Any finite number.
    F32(Vec<f32>),
}

/// A height map, and with it the one surface that every method traces.
///
/// Texel (i, j) has its centre at (i, j): positions count in texels from the centre of the first. Cell (i, j) is the
/// square from there to (i + 1, j + 1); over it the surface is the bilinear patch through the four heights. A wrapped map
/// of n texels has n cells a side, a clamped one n − 1, or one degenerate cell if n is 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Heights {
    size: [u32; 2],
    border: Border,
    texels: Texels,
}

/// Why a map is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeightsError {
    /// A side is 0 or longer than [`LARGEST_SIDE`].
    Side(u32),
    /// There are not width × height texels: how many were wanted, how many came.
    Count(usize, usize),
    /// A height is infinite or no number: the index of its texel.
    NotFinite(usize),
}

impl fmt::Display for HeightsError {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Side(side) => write!(to, "a side of {side} texels is not in 1..{LARGEST_SIDE}"),
            Self::Count(wanted, given) => write!(to, "{given} heights, but width times height is {wanted}"),
            Self::NotFinite(index) => write!(to, "the height of texel {index} is no finite number"),
        }
    }
}

impl std::error::Error for HeightsError {}

impl Heights {
    /// A map from its rows, the first row first.
    ///
    /// # Errors
    /// Those of [`HeightsError`].
    pub fn new(size: [u32; 2], border: Border, texels: Texels) -> Result<Self, HeightsError> {
        if let Some(side) = size.into_iter().find(|side| !(1..=LARGEST_SIDE).contains(side)) {
            return Err(HeightsError::Side(side));
        }
        let (wanted, given) = (size[0] as usize * size[1] as usize, texels.len());
        if wanted != given {
            return Err(HeightsError::Count(wanted, given));
        }
        if let Texels::F32(values) = &texels
            && let Some(index) = values.iter().position(|value| !value.is_finite())
        {
            return Err(HeightsError::NotFinite(index));
        }
        Ok(Self { size, border, texels })
    }

    /// Columns and rows of texels.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// What lies beyond the border.
    #[must_use]
    pub fn border(&self) -> Border {
        self.border
    }

    /// The heights, row by row.
    #[must_use]
    pub fn texels(&self) -> &Texels {
        &self.texels
    }

    /// Columns and rows of cells.
    #[must_use]
    pub fn cells(&self) -> [u32; 2] {
        self.border.cells(self.size)
    }

    /// The height of a texel, by its border's rule where it lies outside.
    #[must_use]
    pub fn height(&self, x: i64, y: i64) -> f64 {
        let [x, y] = [(x, self.size[0]), (y, self.size[1])].map(|(at, side)| match self.border {
            Border::Wrap => at.rem_euclid(i64::from(side)) as usize,
            Border::Clamp => at.clamp(0, i64::from(side) - 1) as usize,
        });
        self.texel([x, y])
    }

    /// The height of a texel of the map.
    pub(crate) fn texel(&self, [x, y]: [usize; 2]) -> f64 {
        self.texels.height(y * self.size[0] as usize + x)
    }

    /// The heights around a cell: at its corner, one to the right, one down, and both.
    #[must_use]
    pub fn corners(&self, x: i64, y: i64) -> [f64; 4] {
        [self.height(x, y), self.height(x + 1, y), self.height(x, y + 1), self.height(x + 1, y + 1)]
    }

    /// The largest height. Looks at every texel.
    #[must_use]
    pub fn highest(&self) -> f64 {
        self.texels.highest()
    }

    /// The surface at a position in texels.
    #[must_use]
    pub fn surface(&self, x: f64, y: f64) -> f64 {
        let (i, j) = (x.floor(), y.floor());
        let (u, v) = (x - i, y - j);
        let [a, b, c, d] = self.corners(i as i64, j as i64);
        (a * (1.0 - u) + b * u) * (1.0 - v) + (c * (1.0 - u) + d * u) * v
    }
}

impl Texels {
    fn len(&self) -> usize {
        match self {
            Self::U8(values) => values.len(),
            Self::U16(values) => values.len(),
            Self::F32(values) => values.len(),
        }
    }

    fn highest(&self) -> f64 {
        match self {
            Self::U8(values) => values.iter().max().map_or(0.0, |value| f64::from(*value)),
            Self::U16(values) => values.iter().max().map_or(0.0, |value| f64::from(*value)),
            Self::F32(values) => values.iter().fold(f64::NEG_INFINITY, |top, value| top.max(f64::from(*value))),
        }
    }

    /// Any of the three as a number that holds it exactly.
    fn height(&self, index: usize) -> f64 {
        match self {
            Self::U8(values) => f64::from(values[index]),
            Self::U16(values) => f64::from(values[index]),
            Self::F32(values) => f64::from(values[index]),
        }
    }
}
