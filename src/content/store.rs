//! PNG files that know their recipe, and are replaced in one step or not at all.

use std::fs::File;
use std::io::{BufReader, BufWriter, Write};
use std::path::Path;

use super::error::Error;
use super::map::{Map, Texels};

/// The keyword of the text chunk that holds the recipe.
const KEYWORD: &str = "terrane:recipe";

/// Whether a file is there and was made by this recipe.
pub fn is_current(path: &Path, recipe: &str) -> bool {
    read_recipe(path).is_some_and(|found| found == recipe)
}

fn read_recipe(path: &Path) -> Option<String> {
    let file = BufReader::new(File::open(path).ok()?);
    let reader = png::Decoder::new(file).read_info().ok()?;
    let texts = &reader.info().uncompressed_latin1_text;
    texts.iter().find(|text| text.keyword == KEYWORD).map(|text| text.text.clone())
}

/// Writes a file beside the target and renames it: a crash leaves what was there before.
///
/// # Errors
/// If the folder cannot be made or the file not be written.
pub fn write(path: &Path, map: &Map, recipe: &str) -> Result<(), Error> {
    let failed = |source: std::io::Error| Error { path: path.to_path_buf(), source };
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder).map_err(failed)?;
    let mut file = temporary(folder).map_err(failed)?;
    let mut buffer = BufWriter::new(file.as_file_mut());
    encode(&mut buffer, map, recipe).map_err(|error| failed(error.into()))?;
    buffer.flush().map_err(failed)?;
    drop(buffer);
    file.persist(path).map_err(|error| failed(error.error))?;
    Ok(())
}

fn temporary(folder: &Path) -> std::io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".").suffix(".png.new");
    // A temporary file is private by default; a texture need not be.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    builder.tempfile_in(folder)
}

/// The bytes of the PNG.
///
/// # Errors
/// If the writer fails.
pub fn encode(out: impl Write, map: &Map, recipe: &str) -> Result<(), png::EncodingError> {
    let size = map.size as u32;
    let mut encoder = png::Encoder::new(out, size, size);
    let (color, depth) = match map.texels {
        Texels::Grey16(_) => (png::ColorType::Grayscale, png::BitDepth::Sixteen),
        Texels::Grey8(_) => (png::ColorType::Grayscale, png::BitDepth::Eight),
        Texels::Srgb8(_) | Texels::Rgb8(_) => (png::ColorType::Rgb, png::BitDepth::Eight),
    };
    encoder.set_color(color);
    encoder.set_depth(depth);
    if matches!(map.texels, Texels::Srgb8(_)) {
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    }
    encoder.add_text_chunk(KEYWORD.into(), recipe.into())?;
    let mut writer = encoder.write_header()?;
    match &map.texels {
        Texels::Grey16(texels) => {
            let bytes: Vec<u8> = texels.iter().flat_map(|texel| texel.to_be_bytes()).collect();
            writer.write_image_data(&bytes)?;
        }
        Texels::Grey8(bytes) | Texels::Srgb8(bytes) | Texels::Rgb8(bytes) => writer.write_image_data(bytes)?,
    }
    writer.finish()
}
