//! Texels ready to be uploaded.

/// Texels of an image.
#[derive(Clone, Debug, PartialEq)]
pub enum Words {
    /// `r16uint`, mip by mip.
    R16(Vec<Vec<u16>>),
    /// `rg16uint`, mip by mip.
    Rg16(Vec<Vec<[u16; 2]>>),
    /// `r32uint`, for a storage texture.
    R32(Vec<u32>),
    /// `rg32uint`, mip by mip; of one mip for a storage texture.
    Rg32(Vec<Vec<[u32; 2]>>),
    /// `rgba32uint`.
    Rgba32(Vec<[u32; 4]>),
}

/// An image for a shader's `texture_2d_array<u32>`.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// Columns and rows of the first mip.
    pub size: [u32; 2],
    /// Its texels.
    pub words: Words,
}

impl Plane {
    /// Bytes of all its mips.
    #[must_use]
    pub fn bytes(&self) -> usize {
        match &self.words {
            Words::R16(mips) => mips.iter().map(|mip| size_of_val(&mip[..])).sum(),
            Words::Rg16(mips) => mips.iter().map(|mip| size_of_val(&mip[..])).sum(),
            Words::R32(words) => size_of_val(&words[..]),
            Words::Rg32(mips) => mips.iter().map(|mip| size_of_val(&mip[..])).sum(),
            Words::Rgba32(words) => size_of_val(&words[..]),
        }
    }

    /// How many mips it has.
    #[must_use]
    pub fn mips(&self) -> usize {
        match &self.words {
            Words::R16(mips) => mips.len(),
            Words::Rg16(mips) => mips.len(),
            Words::Rg32(mips) => mips.len(),
            Words::R32(_) | Words::Rgba32(_) => 1,
        }
    }

    /// What a shader loads: 0 for channels that the texels lack, but 1 for the last; `None` beyond the border or the last mip.
    #[must_use]
    pub fn texel(&self, mip: usize, [x, y]: [u32; 2]) -> Option<[u32; 4]> {
        let [width, height] = self.size.map(|side| (side >> mip).max(1));
        let at = (x < width && y < height).then_some((y * width + x) as usize)?;
        Some(match &self.words {
            Words::R16(mips) => [u32::from(mips.get(mip)?[at]), 0, 0, 1],
            Words::Rg16(mips) => {
                let [red, green] = mips.get(mip)?[at].map(u32::from);
                [red, green, 0, 1]
            }
            Words::Rg32(mips) => {
                let [red, green] = mips.get(mip)?[at];
                [red, green, 0, 1]
            }
            // These have one mip.
            Words::R32(words) => [words[at], 0, 0, 1],
            Words::Rgba32(words) => words[at],
        })
    }
}
