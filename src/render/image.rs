//! A finished picture and the file that it becomes.

use std::io::{BufWriter, Write as _};
use std::path::Path;

use super::error::{RenderError, Result};

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
    /// Writes a PNG beside `path` and renames it, so that a failure leaves an older picture as it was.
    ///
    /// # Errors
    /// [`RenderError::Write`] where the folder is missing or not writable, or the disk is full.
    pub fn write_png(&self, path: &Path) -> Result<()> {
        self.try_write_png(path).map_err(|reason| RenderError::Write { path: path.to_owned(), reason })
    }

    fn try_write_png(&self, path: &Path) -> std::result::Result<(), String> {
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let mut file = tempfile::Builder::new()
            .prefix(".terrane-")
            .suffix(".png")
            .permissions(public_permissions())
            .tempfile_in(folder)
            .map_err(|error| error.to_string())?;
        self.encode(BufWriter::new(file.as_file_mut())).map_err(|error| error.to_string())?;
        file.as_file_mut().flush().map_err(|error| error.to_string())?;
        file.persist(path).map_err(|error| error.to_string())?;
        Ok(())
    }

    /// Encodes to PNG with the sRGB chunk.
    ///
    /// # Errors
    /// What the writer reports.
    pub fn encode(&self, to: impl std::io::Write) -> std::result::Result<(), png::EncodingError> {
        let mut encoder = png::Encoder::new(to, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.pixels)?;
        writer.finish()
    }
}

/// A temporary file is private to its owner; a picture is for everybody who may read the folder.
#[cfg(unix)]
fn public_permissions() -> std::fs::Permissions {
    use std::os::unix::fs::PermissionsExt as _;
    std::fs::Permissions::from_mode(0o644)
}

#[cfg(not(unix))]
fn public_permissions() -> std::fs::Permissions {
    // Windows takes the folder's access list; only the read-only flag exists, and a new file's metadata has it unset.
    std::env::temp_dir().metadata().map(|data| data.permissions()).expect("the temporary folder exists")
}
