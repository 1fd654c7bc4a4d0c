//! Pictures as the tests read and write them.

use std::fs::File;
use std::io::{BufReader, BufWriter};
use std::path::Path;

/// Red, green and blue of every pixel, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Picture {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// Reads a PNG of 8 bits with or without opacity.
    pub(crate) fn read(path: &Path) -> Result<Self, String> {
        let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let file = BufReader::new(File::open(path).map_err(|error| fail(&error))?);
        let mut reader = png::Decoder::new(file).read_info().map_err(|error| fail(&error))?;
        let mut bytes = vec![0; reader.output_buffer_size().ok_or_else(|| fail(&"too large"))?];
        let frame = reader.next_frame(&mut bytes).map_err(|error| fail(&error))?;
        let pixels = bytes.chunks_exact(frame.color_type.samples()).map(|pixel| [pixel[0], pixel[1], pixel[2]]);
        Ok(Self { width: frame.width, height: frame.height, pixels: pixels.collect() })
    }

    /// Writes a PNG, as small as it gets.
    pub(crate) fn write(&self, path: &Path) -> Result<(), String> {
        let file = File::create(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let mut encoder = png::Encoder::new(BufWriter::new(file), self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_compression(png::Compression::High);
        let mut writer = encoder.write_header().map_err(|error| error.to_string())?;
        writer.write_image_data(self.pixels.as_flattened()).map_err(|error| error.to_string())
    }
}
