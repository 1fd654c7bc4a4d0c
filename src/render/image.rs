//! A finished picture and the file that it becomes.

use std::path::Path;

use crate::file;

/// An opaque picture, 8 bits per channel, sRGB.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// Pixels to the right.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Red, green, blue; row by row from the top.
    pub pixels: Vec<u8>,
}

impl Image {
    /// Writes a PNG in one step, so that a failure leaves an older picture as it was. Folders that are missing are made.
    ///
    /// # Errors
    /// If the folder cannot be made or written to, or the disk is full.
    pub fn write_png(&self, path: &Path) -> Result<(), file::Error> {
        let mut bytes = Vec::new();
        self.encode(&mut bytes).map_err(|error| file::Error { path: path.to_owned(), source: error.into() })?;
        file::write(path, &bytes)
    }

    /// Encodes to PNG with the sRGB chunk.
    ///
    /// # Errors
    /// What the writer reports.
    pub fn encode(&self, to: impl std::io::Write) -> Result<(), png::EncodingError> {
        let mut encoder = png::Encoder::new(to, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.pixels)?;
        writer.finish()
    }
}
