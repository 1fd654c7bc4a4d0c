//! The test project: a small library and a valid project around which every case changes something.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use terrane_codegen::diagnostic::Sources;
use terrane_codegen::graph::{Memory, OpenError, Project};
use terrane_codegen::library::Library;

/// Where the cases, the small library and the valid project lie.
pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/diagnostics")
}

/// Every file below a folder, by its path in it.
pub(crate) fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut waiting = vec![folder.to_owned()];
    while let Some(next) = waiting.pop() {
        for entry in fs::read_dir(&next).expect("the test folders are there") {
            let path = entry.expect("a readable folder").path();
            if path.is_dir() {
                waiting.push(path);
                continue;
            }
            let inner =
                path.strip_prefix(folder).expect("it was found there").to_str().expect("test files have ASCII names");
            found.insert(inner.replace('\\', "/"), fs::read(&path).expect("a readable file"));
        }
    }
    found
}

/// The valid project.
pub(crate) fn base() -> Memory {
    Memory(files(&folder().join("base")))
}

/// A project of some files, with the small library.
pub(crate) fn project(files: Memory) -> Result<Project, OpenError> {
    let mut sources = Sources::default();
    let text = |(path, bytes)| (path, String::from_utf8(bytes).expect("WGSL is UTF-8"));
    let library = Library::from_files(&mut sources, self::files(&folder().join("library")).into_iter().map(text));
    let library = library.unwrap_or_else(|findings| panic!("{findings:#?}"));
    Project::with(PathBuf::new(), Box::new(files), library, sources)
}
