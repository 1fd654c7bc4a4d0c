//! A piece of a file that holds one value.

use ron::Deserializer;
use ron::value::RawValue;
use serde::Deserialize as _;
use serde::de::{Deserializer as _, IgnoredAny};

use super::error::invalid;
use super::shape::{Look, Shape};
use crate::diagnostic::{Diagnostic, SourceId, Span};
use crate::graph::codes;

/// The text of one value in its file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Raw<'a> {
    source: SourceId,
    file: &'a str,
    text: &'a str,
}

impl<'a> Raw<'a> {
    /// The value of a whole file, once `ron` has accepted all of it.
    ///
    /// # Errors
    /// Bad syntax, and extensions: they would change how the same text reads.
    pub(crate) fn file(source: SourceId, file: &'a str) -> Result<Self, Diagnostic> {
        let refuse = |error| invalid(source, file, 0, &error);
        ron::from_str::<IgnoredAny>(file).map_err(refuse)?;
        let deserializer = Deserializer::from_str(file).map_err(refuse)?;
        let text = deserializer.remainder();
        let whole = Self { source, file, text };
        if deserializer.extensions().is_empty() {
            return Ok(whole);
        }
        let header = file[..file.len() - text.len()].trim_end().len();
        let header = Span { source, start: 0, end: header as u32 };
        Err(Diagnostic::error(codes::INVALID_RON, header, "RON extensions are enabled")
            .help("delete the `#![enable(…)]` line: graph files are plain RON"))
    }

    /// Its text, without comments around it.
    pub(crate) fn text(self) -> &'a str {
        self.text
    }

    /// Where it lies.
    pub(crate) fn span(self) -> Span {
        self.span_of(self.text)
    }

    /// Where a slice of the same file lies.
    pub(crate) fn span_of(self, slice: &str) -> Span {
        let start = slice.as_ptr() as usize - self.file.as_ptr() as usize;
        Span { source: self.source, start: start as u32, end: (start + slice.len()) as u32 }
    }

    /// A value inside this one.
    pub(super) fn part(self, raw: &'a RawValue) -> Self {
        let text = raw.get_ron();
        // `trim` parses the value once more; only a text with a slash can have a comment at its ends.
        let bare = text.starts_with(|c: char| c.is_ascii_graphic()) && text.ends_with(|c: char| c.is_ascii_graphic());
        let raw = if bare && !text.contains('/') { raw } else { raw.trim() };
        Self { text: raw.get_ron(), ..self }
    }

    /// What it is, one level deep.
    ///
    /// # Errors
    /// None that [`Raw::file`] has not found already, unless `ron` disagrees with itself.
    pub(crate) fn shape(self) -> Result<Shape<'a>, Diagnostic> {
        let base = self.span().start as usize;
        let refuse = |error| invalid(self.source, self.text, base, &error);
        let mut deserializer = Deserializer::from_str(self.text).map_err(refuse)?;
        let shape = deserializer.deserialize_any(Look(self)).map_err(|error| refuse(deserializer.span_error(error)))?;
        deserializer.end().map_err(|error| refuse(deserializer.span_error(error)))?;
        Ok(shape)
    }
}

/// Reads one value as its text.
pub(super) struct Capture<'a>(pub(super) Raw<'a>);

impl<'de> serde::de::DeserializeSeed<'de> for Capture<'de> {
    type Value = Raw<'de>;

    fn deserialize<D: serde::Deserializer<'de>>(self, deserializer: D) -> Result<Raw<'de>, D::Error> {
        <&'de RawValue>::deserialize(deserializer).map(|raw| self.0.part(raw))
    }
}
