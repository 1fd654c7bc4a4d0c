//! From declarations to node kinds, and every rule that a node file must keep.

mod example;
mod kind;
mod overload;
mod port;

use std::ops::Range;

use super::item::Item;
use super::{Library, LibraryFile, codes};
use crate::diagnostic::{Code, Diagnostic};

/// Suffixes that make a function an overload of its file's kind.
const SUFFIXES: [&str; 6] = ["f32", "vec2", "vec3", "vec4", "i32", "u32"];

/// Fills `kinds` and `structs`; gives what is wrong.
pub(super) fn read(library: &mut Library) -> Vec<Diagnostic> {
    let mut reader = Reader { library, findings: Vec::new() };
    let structs: Vec<_> = reader.library.items.iter().filter(|item| item.keyword == "struct").cloned().collect();
    for item in structs {
        let members = reader.members(&item);
        reader.library.structs.insert(item.name.clone(), members);
    }
    for file in reader.library.files.clone() {
        reader.file(&file);
    }
    reader.findings
}

struct Reader<'a> {
    library: &'a mut Library,
    findings: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn error(&mut self, code: Code, range: Range<usize>, message: impl Into<String>, help: &str) {
        let span = self.library.span(range);
        self.findings.push(Diagnostic::error(code, span, message).help(help));
    }

    fn file(&mut self, file: &LibraryFile) {
        let items: Vec<Item> =
            self.library.items.iter().filter(|item| within(&item.range, &file.range)).cloned().collect();
        let (category, stem) = category_and_stem(&file.path);
        for item in &items {
            self.declaration(item, stem);
        }
        let is_node = |item: &&Item| item.keyword == "fn" && is_node_function(&item.name, stem);
        let functions: Vec<Item> = items.iter().filter(is_node).cloned().collect();
        if !functions.is_empty() {
            self.kind(file, category, stem, &functions);
        }
    }

    fn declaration(&mut self, item: &Item, stem: &str) {
        if !matches!(item.keyword.as_str(), "fn" | "struct" | "const" | "alias") {
            let message = format!("a library file declares `{}`", item.keyword);
            self.error(
                codes::FOREIGN_DECLARATION,
                item.name_range.clone(),
                message,
                "only functions, structs, constants and aliases: resources are arguments",
            );
        }
        let flat = item.name.to_lowercase().replace('_', "");
        if !flat.starts_with(&stem.replace('_', "")) {
            let message = format!("`{}` does not begin with `{stem}`", item.name);
            self.error(
                codes::NAME_WITHOUT_STEM,
                item.name_range.clone(),
                message,
                "all files share one namespace: begin every name with the stem of its file",
            );
        }
    }
}

fn within(inner: &Range<usize>, outer: &Range<usize>) -> bool {
    outer.start <= inner.start && inner.end <= outer.end
}

fn category_and_stem(path: &str) -> (&str, &str) {
    let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
    (folder.rsplit('/').next().unwrap_or(folder), file.strip_suffix(".wgsl").unwrap_or(file))
}

fn is_node_function(name: &str, stem: &str) -> bool {
    name == stem
        || name
            .strip_prefix(stem)
            .and_then(|rest| rest.strip_prefix('_'))
            .is_some_and(|suffix| SUFFIXES.contains(&suffix))
}
