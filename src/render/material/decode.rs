//! PNG files as texels.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use super::{Format, channels};
use crate::render::error::{RenderError, Result};

/// Texels as the file stores them, 0..1, with the channels that the format asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Texels {
    /// Width and height.
    pub size: (u32, u32),
    /// 1 or 4.
    pub channels: usize,
    /// Row by row. Colours are still encoded as in the file.
    pub values: Vec<f32>,
}

/// Reads a PNG of the expected size. Grey becomes red, green and blue; where there is no alpha it is 1.
///
/// # Errors
/// [`RenderError::Texture`] where the file is missing, broken, or of another size.
pub fn decode(path: &Path, size: (u32, u32), format: Format) -> Result<Texels> {
    try_decode(path, size, format).map_err(|reason| RenderError::Texture { path: path.to_owned(), reason })
}

fn try_decode(path: &Path, size: (u32, u32), format: Format) -> std::result::Result<Texels, String> {
    let mut reader = open(path)?;
    // Before anything of the file's size is allocated.
    let (width, height) = reader.info().size();
    if (width, height) != size {
        return Err(format!("is {width} x {height}, expected {} x {}", size.0, size.1));
    }
    let values = match samples(&mut reader)? {
        Samples::Sixteen(values) => values.into_iter().map(|value| f32::from(value) / 65535.0).collect::<Vec<_>>(),
        Samples::Eight(bytes) => bytes.into_iter().map(|byte| f32::from(byte) / 255.0).collect(),
    };
    let channels = channels(format);
    Ok(Texels { size, channels, values: spread(&values, reader.output_color_type().0.samples(), channels) })
}

/// A PNG whose header has been read; fewer than 8 bits become 8, a palette its colours.
pub(crate) fn open(path: &Path) -> std::result::Result<png::Reader<BufReader<File>>, String> {
    let file = File::open(path).map_err(|error| error.to_string())?;
    let mut decoder = png::Decoder::new(BufReader::new(file));
    decoder.set_transformations(png::Transformations::EXPAND);
    decoder.read_info().map_err(|error| error.to_string())
}

/// Samples as the file stores them, channel by channel.
pub(crate) enum Samples {
    /// 0..255.
    Eight(Vec<u8>),
    /// 0..65535.
    Sixteen(Vec<u16>),
}

/// All samples of an open PNG.
pub(crate) fn samples(reader: &mut png::Reader<BufReader<File>>) -> std::result::Result<Samples, String> {
    let length = reader.output_buffer_size().ok_or("is too large")?;
    let mut bytes = vec![0; length];
    let frame = reader.next_frame(&mut bytes).map_err(|error| error.to_string())?;
    bytes.truncate(frame.buffer_size());
    Ok(match frame.bit_depth {
        png::BitDepth::Sixteen => {
            Samples::Sixteen(bytes.chunks_exact(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect())
        }
        _ => Samples::Eight(bytes),
    })
}

/// From grey, grey and alpha, RGB or RGBA to one channel or four.
fn spread(values: &[f32], from: usize, to: usize) -> Vec<f32> {
    let texel = |texel: &[f32]| match texel {
        [grey] => [*grey, *grey, *grey, 1.0],
        [grey, alpha] => [*grey, *grey, *grey, *alpha],
        [red, green, blue] => [*red, *green, *blue, 1.0],
        [red, green, blue, alpha, ..] => [*red, *green, *blue, *alpha],
        [] => [0.0; 4],
    };
    values.chunks_exact(from).flat_map(|values| texel(values).into_iter().take(to)).collect()
}
