//! Text that remembers which value or declaration each of its bytes came from.

use std::ops::Range;

use crate::program::ValueId;

/// Where a piece of emitted text came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A value of the program.
    Value(ValueId),
    /// A declaration of the library: position in [`crate::library::Library::items`].
    Item(usize),
    /// A layer: position in [`crate::program::Program::layers`].
    Layer(usize),
}

/// Emitted WGSL.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shader {
    /// The text.
    pub text: String,
    /// Origins of byte ranges, in order; ranges do not overlap.
    pub map: Vec<(Range<usize>, Place)>,
    depth: usize,
}

impl Shader {
    /// Adds a line at the present depth.
    pub(super) fn line(&mut self, line: &str) {
        if !line.is_empty() {
            self.text.extend(std::iter::repeat_n("    ", self.depth));
            self.text.push_str(line);
        }
        self.text.push('\n');
    }

    /// Adds a line that came from somewhere.
    pub(super) fn mapped(&mut self, place: Place, line: &str) {
        let start = self.text.len();
        self.line(line);
        self.map.push((start..self.text.len(), place));
    }

    /// Adds text as it is.
    pub(super) fn verbatim(&mut self, place: Place, text: &str) {
        let start = self.text.len();
        self.text.push_str(text);
        self.text.push_str("\n\n");
        self.map.push((start..self.text.len(), place));
    }

    /// Opens a block: `head {`.
    pub(super) fn open(&mut self, head: &str) {
        self.line(&format!("{head} {{"));
        self.depth += 1;
    }

    /// Closes the innermost block.
    pub(super) fn close(&mut self) {
        self.depth -= 1;
        self.line("}");
    }

    /// Adds another shader's text behind this one's.
    pub(super) fn append(&mut self, other: Self) {
        let offset = self.text.len();
        self.text.push_str(&other.text);
        self.map.extend(other.map.into_iter().map(|(range, place)| (range.start + offset..range.end + offset, place)));
    }

    /// What the bytes came from: the last place that holds the start.
    pub fn place(&self, byte: usize) -> Option<Place> {
        self.map.iter().rfind(|(range, _)| range.contains(&byte)).map(|(_, place)| *place)
    }
}
