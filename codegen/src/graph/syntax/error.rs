//! `ron`'s refusal as a diagnostic with the place in the file.

use ron::error::{Error, Position, SpannedError};

use super::bracket::open_bracket;
use crate::diagnostic::{Diagnostic, SourceId, Span};
use crate::graph::{codes, limits};

/// Says what `ron` says, where it says it. `text` is what it read; it begins at byte `base` of the file.
pub(super) fn invalid(source: SourceId, text: &str, base: usize, error: &SpannedError) -> Diagnostic {
    let range = |start: usize, end: usize| Span { source, start: (base + start) as u32, end: (base + end) as u32 };
    let (start, end) = (byte(text, &error.span.start), byte(text, &error.span.end));
    // Where reading stopped is where to look, unless one line shows all of it.
    let start = if text.get(start..end).is_some_and(|piece| !piece.contains('\n')) { start } else { end };
    let span = range(start, end);
    if error.code == Error::ExceededRecursionLimit {
        let message = format!("brackets are nested more than {} deep", limits::DEPTH);
        return Diagnostic::error(codes::LIMIT, range(end, end), message).help("a graph file needs six levels");
    }
    let words = error.code.to_string();
    let finding = Diagnostic::error(codes::INVALID_RON, span, format!("not valid RON: {}", decapitalised(&words)))
        .help("nothing in this file is looked at before its syntax is right");
    match open_bracket(&text[..end]) {
        Some(open) => finding.also(range(open, open + 1), "inside this"),
        None => finding,
    }
}

/// The byte of a line and column (both from 1, columns in characters).
fn byte(text: &str, position: &Position) -> usize {
    let line_start: usize = text.split_inclusive('\n').take(position.line - 1).map(str::len).sum();
    let line = &text[line_start..];
    line_start + line.char_indices().nth(position.col - 1).map_or(line.len(), |(byte, _)| byte)
}

fn decapitalised(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}
