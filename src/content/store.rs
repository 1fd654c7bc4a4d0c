//! PNG files that know their recipe, and are replaced in one step or not at all.

use std::fs::File;
use std::io::{BufReader, Write};
use std::path::Path;

use super::map::{Map, Texels};
use crate::file::{self, Error};

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

/// Writes the PNG in one step: a crash leaves what was there before.
///
/// # Errors
/// If the folder cannot be made or the file not be written.
pub fn write(path: &Path, map: &Map, recipe: &str) -> Result<(), Error> {
    let mut bytes = Vec::new();
    encode(&mut bytes, map, recipe).map_err(|error| Error { path: path.to_path_buf(), source: error.into() })?;
    file::write(path, &bytes)
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
