//! Diagnostics as text with source lines and carets.

use codespan_reporting::diagnostic as report;
use codespan_reporting::files::SimpleFiles;
use codespan_reporting::term::{self, Config, termcolor};

use super::{Diagnostic, Label, Level, Sources, Span};

/// Renders the findings, in their order. Colour is for terminals only.
pub fn render(diagnostics: &[Diagnostic], sources: &Sources, color: bool) -> String {
    let mut files = SimpleFiles::new();
    for source in sources.iter() {
        files.add(source.path.as_str(), source.text.as_str());
    }
    let mut buffer = if color { termcolor::Buffer::ansi() } else { termcolor::Buffer::no_color() };
    for diagnostic in diagnostics {
        // Writing to memory fails only where a span leaves its text: the message alone is still worth having.
        let report = convert(diagnostic, sources);
        if term::emit_to_write_style(&mut buffer, &Config::default(), &files, &report).is_err() {
            use std::io::Write as _;
            let _ = writeln!(buffer, "{}: {}", diagnostic.code.name, diagnostic.message);
        }
    }
    String::from_utf8_lossy(buffer.as_slice()).into_owned()
}

/// Bytes of a line that a person reads. Generated files can hold everything in one line.
const LONGEST_LINE: usize = 400;

fn convert(diagnostic: &Diagnostic, sources: &Sources) -> report::Diagnostic<usize> {
    let (shown, hidden): (Vec<_>, Vec<_>) = diagnostic.labels.iter().enumerate().partition(|(_, label)| {
        let source = sources.get(label.span.source);
        source.text.get(label.span.range()).is_none() || line_length(&source.text, label.span) <= LONGEST_LINE
    });
    let labels = shown.into_iter().map(|(index, label)| {
        let style = if index == 0 { report::LabelStyle::Primary } else { report::LabelStyle::Secondary };
        report::Label::new(style, label.span.source.0 as usize, label.span.range()).with_message(label.text.clone())
    });
    let help = diagnostic.help.iter().map(|help| format!("help: {help}"));
    let places = hidden.into_iter().map(|(_, label)| place(label, sources));
    let notes = diagnostic.notes.iter().map(|note| format!("note: {note}"));
    let severity = match diagnostic.level {
        Level::Error => report::Severity::Error,
        Level::Warning => report::Severity::Warning,
    };
    report::Diagnostic::new(severity)
        .with_code(format!("{} {}", diagnostic.code.id, diagnostic.code.name))
        .with_message(&diagnostic.message)
        .with_labels(labels.collect())
        .with_notes(help.chain(notes).chain(places).collect())
}

/// Bytes of the lines that a span touches.
fn line_length(text: &str, span: Span) -> usize {
    let (start, end) = (span.range().start, span.range().end);
    let first = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
    let last = text[end..].find('\n').map_or(text.len(), |newline| end + newline);
    last - first
}

/// A label whose line is too long to be shown.
fn place(label: &Label, sources: &Sources) -> String {
    let source = label.span.source;
    let (line, column) = sources.position(source, label.span.range().start);
    let text = if label.text.is_empty() { String::new() } else { format!(": {}", label.text) };
    format!("at {}:{line}:{column}{text}, in a line too long to be shown", sources.get(source).path)
}
