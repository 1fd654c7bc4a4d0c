//! What is measured on.

use std::fmt;
use std::path::Path;

use terrane_shaderlib::heightfield::{Border, Heights, HeightsError, LARGEST_SIDE, Texels};

use crate::render::material::{Samples, open, samples};

/// A map and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// For the report.
    pub name: String,
    /// The map.
    pub heights: Heights,
    /// Steps of height that make the whole depth.
    pub full: f64,
}

/// Why a file is no map.
#[derive(Debug)]
pub enum SubjectError {
    /// It cannot be opened or decoded.
    Png(String),
    /// It has colours, or fewer than 8 bits.
    Kind(String),
    /// Its size cannot be traced.
    Heights(HeightsError),
}

impl fmt::Display for SubjectError {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Png(reason) => write!(to, "cannot be read: {reason}"),
            Self::Kind(kind) => write!(to, "is {kind}; a height map is grey, with 8 or 16 bits"),
            Self::Heights(error) => error.fmt(to),
        }
    }
}

impl std::error::Error for SubjectError {}

/// A grey PNG of 8 or 16 bits.
///
/// # Errors
/// Those of [`SubjectError`].
pub fn read(path: &Path, border: Border) -> Result<Subject, SubjectError> {
    let mut reader = open(path).map_err(SubjectError::Png)?;
    let (color, depth) = reader.output_color_type();
    if color != png::ColorType::Grayscale {
        return Err(SubjectError::Kind(format!("{color:?} with {} bits", depth as u8)));
    }
    let size = [reader.info().width, reader.info().height];
    // Before anything of the file's size is allocated.
    if let Some(side) = size.into_iter().find(|side| *side > LARGEST_SIDE) {
        return Err(SubjectError::Heights(HeightsError::Side(side)));
    }
    let (texels, full) = match samples(&mut reader).map_err(SubjectError::Png)? {
        Samples::Eight(values) => (Texels::U8(values), 255.0),
        Samples::Sixteen(values) => (Texels::U16(values), 65535.0),
    };
    let heights = Heights::new(size, border, texels).map_err(SubjectError::Heights)?;
    let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    Ok(Subject { name, heights, full })
}
