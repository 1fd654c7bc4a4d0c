//! Height maps of materials: from a channel of an image to what a method reads.

use std::path::Path;

use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::relief::{MapTexture, Plane, Words, planes};

use crate::render::RenderError;
use crate::render::material::{Samples, open, samples};

/// What shaders read of a channel of a PNG that repeats, as heights of 16 bits.
///
/// # Errors
/// [`RenderError::Texture`] for a file that cannot be read or has another size.
pub fn map(path: &Path, channel: u8, size: (u32, u32), textures: &[MapTexture]) -> Result<Vec<Plane>, RenderError> {
    read(path, channel, size, textures).map_err(|reason| RenderError::Texture { path: path.to_owned(), reason })
}

/// The texels of a plane as a file holds them: little-endian, row by row, mip after mip.
#[must_use]
pub fn bytes(plane: &Plane) -> Vec<u8> {
    match &plane.words {
        Words::R16(mips) => mips.iter().flatten().flat_map(|texel| texel.to_le_bytes()).collect(),
        Words::Rg16(mips) => mips.iter().flatten().flatten().flat_map(|part| part.to_le_bytes()).collect(),
        Words::R32(words) => words.iter().flat_map(|word| word.to_le_bytes()).collect(),
        Words::Rg32(mips) => mips.iter().flatten().flatten().flat_map(|word| word.to_le_bytes()).collect(),
        Words::Rgba32(words) => words.iter().flatten().flat_map(|word| word.to_le_bytes()).collect(),
    }
}

fn read(path: &Path, channel: u8, size: (u32, u32), textures: &[MapTexture]) -> Result<Vec<Plane>, String> {
    let mut reader = open(path)?;
    let (width, height) = reader.info().size();
    if (width, height) != size {
        return Err(format!("is {width} x {height}, expected {} x {}", size.0, size.1));
    }
    let channels = reader.output_color_type().0.samples();
    let pick = usize::from(channel).min(channels - 1);
    let texels: Vec<u16> = match samples(&mut reader)? {
        Samples::Sixteen(values) => values.into_iter().skip(pick).step_by(channels).collect(),
        // 255 becomes 65535.
        Samples::Eight(values) => {
            values.into_iter().skip(pick).step_by(channels).map(|byte| u16::from(byte) * 257).collect()
        }
    };
    let heights =
        Heights::new([width, height], Border::Wrap, Texels::U16(texels)).map_err(|error| error.to_string())?;
    planes(&heights, textures).map_err(|error| error.to_string())
}
