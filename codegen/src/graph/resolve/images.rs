//! Images that files name: found on disk, or promised by a recipe.

use std::collections::BTreeMap;

use super::fault::{bad_path, file_error};
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::file::Named;
use crate::graph::files::{FileError, Files};
use crate::graph::image::{self, HEADER_BYTES, ImageError, ImageHeader};
use crate::graph::{codes, limits, path};

/// Where images come from.
#[derive(Clone, Copy)]
pub(super) struct Images<'a> {
    pub(super) files: &'a dyn Files,
    /// By path: what recipes make, whether it is made already or not.
    pub(super) made: &'a BTreeMap<String, ImageHeader>,
}

impl Images<'_> {
    /// The image that a file names: its normalised path and its header.
    pub(super) fn find(&self, file: &Named, findings: &mut Vec<Diagnostic>) -> Option<(String, ImageHeader)> {
        let path = match path::normalise(&file.name) {
            Ok(path) => path,
            Err(why) => {
                findings.push(bad_path(&file.name, why, file.span));
                return None;
            }
        };
        let header = self.header(&path, file.span).map_err(|finding| findings.push(finding)).ok()?;
        Some((path, header))
    }

    /// Whether there is, or will be, something at a normalised path.
    pub(super) fn exists(&self, path: &str) -> bool {
        self.made.contains_key(path) || !matches!(self.files.head(path, 0), Err(FileError::Missing))
    }

    fn header(&self, path: &str, span: Span) -> Result<ImageHeader, Diagnostic> {
        if let Some(header) = self.made.get(path) {
            return Ok(*header);
        }
        let made = self.made.keys().map(String::as_str);
        let bytes =
            self.files.head(path, HEADER_BYTES).map_err(|error| file_error(self.files, made, path, &error, span))?;
        image::header(&bytes).map_err(|error| refusal(path, &error, span))
    }
}

fn refusal(path: &str, error: &ImageError, span: Span) -> Diagnostic {
    match error {
        ImageError::NotPng => Diagnostic::error(codes::BAD_IMAGE, span, format!("`{path}` is not a PNG"))
            .help("images are PNG: 8 or 16 bit, grey, RGB or RGBA"),
        ImageError::Format(found) => {
            let message = format!("`{path}` is a PNG with {found}");
            Diagnostic::error(codes::BAD_IMAGE, span, message).help("save it with 8 or 16 bit, as grey, RGB or RGBA")
        }
        ImageError::Large(width, height) => {
            let message = format!("`{path}` is {width}x{height} pixels");
            let pixels = limits::IMAGE_PIXELS >> 20;
            let help = format!("the limit is {} pixels on a side and {pixels} Mpx", limits::IMAGE_SIDE);
            Diagnostic::error(codes::LIMIT, span, message).help(help)
        }
    }
}
