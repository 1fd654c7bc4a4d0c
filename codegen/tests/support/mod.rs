//! The test project, and the comparison with what a person has accepted.

// Each test binary uses a part of this.
#![allow(dead_code)]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{env, fs};

use terrane_codegen::diagnostic::{Diagnostic, Sources, render};
use terrane_codegen::graph::{Memory, OpenError, Project, codes};
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

/// The valid project that every case changes.
pub(crate) fn base() -> Memory {
    Memory(files(&folder().join("_base")))
}

/// A project of some files, with the small library.
pub(crate) fn project(files: Memory) -> Result<Project, OpenError> {
    let mut sources = Sources::default();
    let library = library(&mut sources);
    Project::with(PathBuf::new(), Box::new(files), library, sources)
}

/// The small library: it does not grow, so that the texts that list kinds do not change.
pub(crate) fn library(sources: &mut Sources) -> Library {
    let text = |(path, bytes)| (path, String::from_utf8(bytes).expect("WGSL is UTF-8"));
    let library = Library::from_files(sources, files(&folder().join("_library")).into_iter().map(text));
    library.unwrap_or_else(|findings| panic!("{}", render(&findings, sources, false)))
}

/// The findings but for the reliefs of the valid project and of the manual, which nothing traces yet.
pub(crate) fn beside_relief(mut findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
    findings.retain(|finding| finding.code != codes::RELIEF_NOT_TRACED);
    findings
}

/// What is found in some files of a project, as a person sees it.
pub(crate) fn report(files: Memory, checked: &[String]) -> String {
    match project(files) {
        Ok(mut project) => {
            let mut findings: Vec<Diagnostic> = checked.iter().flat_map(|path| project.check(path)).collect();
            terrane_codegen::diagnostic::sort(&mut findings);
            render(&findings, &project.sources, false)
        }
        Err(error) => render(&error.diagnostics, &error.sources, false),
    }
}

/// Compares a text with the accepted one. `BLESS=1` accepts the new one; CI never accepts anything.
pub(crate) fn golden(case: &str, found: &str) -> Result<(), String> {
    let path = folder().join(case).join("expected.txt");
    if blessing() {
        fs::create_dir_all(folder().join(case)).expect("a writable folder");
        fs::write(&path, found).expect("a writable file");
        return Ok(());
    }
    let Ok(expected) = fs::read_to_string(&path) else {
        return Err(format!("{case}: there is no expected.txt; look at this, then run with BLESS=1\n{found}"));
    };
    if expected.replace("\r\n", "\n") == found {
        return Ok(());
    }
    Err(format!(
        "{case}: differs from expected.txt; if it is better, run with BLESS=1\n{}",
        difference(&expected, found)
    ))
}

/// Whether what is found now becomes what is accepted. Never in CI.
pub(crate) fn blessing() -> bool {
    env::var_os("BLESS").is_some() && env::var_os("CI").is_none()
}

/// The lines that differ, without those before and after that do not.
fn difference(expected: &str, found: &str) -> String {
    let (expected, found): (Vec<&str>, Vec<&str>) = (expected.lines().collect(), found.lines().collect());
    let same = expected.iter().zip(&found).take_while(|(a, b)| a == b).count();
    let (expected, found) = (&expected[same..], &found[same..]);
    let tail = expected.iter().rev().zip(found.iter().rev()).take_while(|(a, b)| a == b).count();
    let removed = expected[..expected.len() - tail].iter().map(|line| format!("- {line}\n"));
    let added = found[..found.len() - tail].iter().map(|line| format!("+ {line}\n"));
    format!("line {}:\n{}", same + 1, removed.chain(added).collect::<String>())
}

/// A value's debug text without the places: what must be equal when only the layout of a file differs.
pub(crate) fn without_spans(value: &impl std::fmt::Debug) -> String {
    let text = format!("{value:?}");
    let mut kept = String::new();
    let mut rest = text.as_str();
    while let Some(start) = rest.find("Span {") {
        let end = rest[start..].find('}').expect("a span's text has an end");
        kept.push_str(&rest[..start]);
        rest = &rest[start + end + 1..];
    }
    kept + rest
}
