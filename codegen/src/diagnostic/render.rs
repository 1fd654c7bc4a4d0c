//! Diagnostics as text with source lines and carets.

use codespan_reporting::diagnostic as report;
use codespan_reporting::files::SimpleFiles;
use codespan_reporting::term::{self, Config, termcolor};

use super::{Diagnostic, Level, Sources};

/// Renders the findings, in their order. Colour is for terminals only.
pub fn render(diagnostics: &[Diagnostic], sources: &Sources, color: bool) -> String {
    let mut files = SimpleFiles::new();
    for source in sources.iter() {
        files.add(source.path.as_str(), source.text.as_str());
    }
    let mut buffer = if color { termcolor::Buffer::ansi() } else { termcolor::Buffer::no_color() };
    for diagnostic in diagnostics {
        // Writing to memory fails only where a span leaves its text: the message alone is still worth having.
        if term::emit_to_write_style(&mut buffer, &Config::default(), &files, &convert(diagnostic)).is_err() {
            use std::io::Write as _;
            let _ = writeln!(buffer, "{}: {}", diagnostic.code.name, diagnostic.message);
        }
    }
    String::from_utf8_lossy(buffer.as_slice()).into_owned()
}

fn convert(diagnostic: &Diagnostic) -> report::Diagnostic<usize> {
    let labels = diagnostic.labels.iter().enumerate().map(|(index, label)| {
        let style = if index == 0 { report::LabelStyle::Primary } else { report::LabelStyle::Secondary };
        report::Label::new(style, label.span.source.0 as usize, label.span.range()).with_message(label.text.clone())
    });
    let help = diagnostic.help.iter().map(|help| format!("help: {help}"));
    let notes = diagnostic.notes.iter().map(|note| format!("note: {note}"));
    let severity = match diagnostic.level {
        Level::Error => report::Severity::Error,
        Level::Warning => report::Severity::Warning,
    };
    report::Diagnostic::new(severity)
        .with_code(format!("{} {}", diagnostic.code.id, diagnostic.code.name))
        .with_message(&diagnostic.message)
        .with_labels(labels.collect())
        .with_notes(help.chain(notes).collect())
}
