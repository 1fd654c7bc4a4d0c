//! A file's own documentation: what its kind does, and where it comes from.

use super::Reader;
use crate::library::item::Item;
use crate::library::kind::{Example, Kind, Overload};
use crate::library::token::{Token, tokens};
use crate::library::{LibraryFile, codes};

impl Reader<'_> {
    pub(super) fn kind(&mut self, file: &LibraryFile, category: &str, stem: &str, functions: &[Item]) {
        let (lines, source) = file_doc(&self.library.text, file);
        let doc = lines.join("\n");
        let prose = lines.join(" ");
        let summary = prose.split_once(". ").map_or(prose.as_str(), |(first, _)| first);
        let overloads: Vec<Overload> = functions.iter().filter_map(|item| self.overload(item)).collect();
        let examples: Vec<Example> = functions.iter().flat_map(|item| self.examples(item)).collect();
        let place = functions[0].name_range.clone();
        if summary.is_empty() {
            self.error(
                codes::NODE_UNDOCUMENTED,
                place.clone(),
                format!("node `{stem}` has no `//!` line"),
                "say in one sentence what it does, at the top of the file",
            );
        }
        if source.is_empty() {
            self.error(
                codes::NODE_UNDOCUMENTED,
                place.clone(),
                format!("node `{stem}` has no source"),
                "add a line `//! Source: …` that names the paper, section or listing",
            );
        }
        if examples.is_empty() {
            self.error(
                codes::NODE_UNDOCUMENTED,
                place,
                format!("node `{stem}` has no example"),
                "add a line `/// name(…) == value +- tolerance` above the function",
            );
        }
        let summary = summary.trim_end_matches('.').to_owned() + ".";
        let kind = Kind { name: stem.into(), category: category.into(), summary, doc, source, overloads, examples };
        self.library.kinds.insert(stem.into(), kind);
    }
}

/// The `//!` lines of a file, and what its source line says.
fn file_doc(text: &str, file: &LibraryFile) -> (Vec<String>, String) {
    let text = &text[file.range.clone()];
    let docs = tokens(text).into_iter().filter(|(token, _)| *token == Token::FileDoc);
    let lines = docs.map(|(_, range)| text[range.start + 3..range.end].trim().to_owned());
    let (mut doc, mut source, mut in_source) = (Vec::new(), Vec::new(), false);
    for line in lines {
        if let Some(first) = line.strip_prefix("Source:") {
            in_source = true;
            source.push(first.trim().to_owned());
        } else if in_source {
            source.push(line);
        } else {
            doc.push(line);
        }
    }
    (doc, source.join(" ").trim().to_owned())
}
