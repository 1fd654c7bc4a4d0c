//! From files to a [`Library`], with every finding at its place.

use std::collections::BTreeMap;
use std::ops::Range;

use naga::valid::{Capabilities, ValidationFlags, Validator};

use super::item::{Item, items};
use super::{Library, LibraryFile, codes, read_kind};
use crate::diagnostic::{Diagnostic, Sources, Span, any_error};

impl Library {
    /// Reads the standard library and a project's own nodes, given as path and text.
    ///
    /// # Errors
    /// Everything that is wrong with the files, in order.
    pub fn load(sources: &mut Sources, project: &[(String, String)]) -> Result<Self, Vec<Diagnostic>> {
        let standard = terrane_shaderlib::FILES.iter().map(|file| (file.path.to_owned(), file.text.to_owned()));
        Self::from_files(sources, standard.chain(project.iter().cloned()))
    }

    /// Reads exactly these files.
    ///
    /// # Errors
    /// Everything that is wrong with the files, in order.
    pub fn from_files(
        sources: &mut Sources,
        files: impl IntoIterator<Item = (String, String)>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let (text, files) = join(sources, files);
        let items = items(&text);
        let names = unique_names(&files, &items)?;
        let (module, info) = parse(&text)
            .map_err(|(range, message)| vec![Diagnostic::error(codes::INVALID_WGSL, span(&files, range), message)])?;
        let exact = super::exact::exact_functions(&module);
        let mut library =
            Self { text, files, items, names, module, info, kinds: BTreeMap::new(), structs: BTreeMap::new(), exact };
        let findings = read_kind::read(&mut library);
        if any_error(&findings) { Err(findings) } else { Ok(library) }
    }
}

fn join(sources: &mut Sources, files: impl IntoIterator<Item = (String, String)>) -> (String, Vec<LibraryFile>) {
    let mut joined = String::new();
    let mut table = Vec::new();
    for (path, text) in files {
        let start = joined.len();
        joined.push_str(&text);
        // A file without a final newline would swallow the next one's first comment.
        joined.push('\n');
        let source = sources.add(path.clone(), text);
        table.push(LibraryFile { source, path, range: start..joined.len() });
    }
    (joined, table)
}

/// The file at a byte of the joined text.
pub(super) fn file(files: &[LibraryFile], byte: usize) -> &LibraryFile {
    let after = files.partition_point(|file| file.range.end <= byte);
    &files[after.min(files.len() - 1)]
}

/// A range of the joined text in its file.
pub(super) fn span(files: &[LibraryFile], range: Range<usize>) -> Span {
    let file = file(files, range.start);
    let last = file.range.end - 1 - file.range.start;
    let start = (range.start - file.range.start).min(last);
    let end = range.end.saturating_sub(file.range.start).clamp(start, last);
    Span { source: file.source, start: start as u32, end: end as u32 }
}

fn unique_names(files: &[LibraryFile], items: &[Item]) -> Result<BTreeMap<String, usize>, Vec<Diagnostic>> {
    let mut names: BTreeMap<String, usize> = BTreeMap::new();
    let mut findings = Vec::new();
    for (index, item) in items.iter().enumerate() {
        if let Some(first) = names.get(&item.name) {
            let message = format!("`{}` is declared twice", item.name);
            findings.push(
                Diagnostic::error(codes::NAME_WITHOUT_STEM, span(files, item.name_range.clone()), message)
                    .also(span(files, items[*first].name_range.clone()), "the first one")
                    .help("all files share one namespace: begin every name with the stem of its file"),
            );
        } else {
            names.insert(item.name.clone(), index);
        }
    }
    if findings.is_empty() { Ok(names) } else { Err(findings) }
}

type Parsed = (naga::Module, naga::valid::ModuleInfo);

/// naga's verdict on a text; a refusal with the place that it names first.
fn parse(text: &str) -> Result<Parsed, (Range<usize>, String)> {
    let module = naga::front::wgsl::parse_str(text).map_err(|error| {
        let place = error.labels().next().and_then(|(span, _)| span.to_range()).unwrap_or(0..0);
        (place, error.message().to_owned())
    })?;
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    let info = validator.validate(&module).map_err(|error| {
        let place = error.spans().filter_map(|(span, _)| span.to_range()).min_by_key(Range::len).unwrap_or(0..0);
        (place, causes(error.as_inner()))
    })?;
    Ok((module, info))
}

/// An error and what caused it, in one line.
pub(crate) fn causes(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut cause = error.source();
    while let Some(error) = cause {
        text.push_str(": ");
        text.push_str(&error.to_string());
        cause = error.source();
    }
    text
}
