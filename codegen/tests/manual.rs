//! `docs/graphs.md` shows a project that works.

use std::path::{Path, PathBuf};

use terrane_codegen::diagnostic::{Level, Sources, render};
use terrane_codegen::graph::{Memory, Project};
use terrane_codegen::library::Library;

/// The blocks of the manual that begin with a comment that names their file.
fn manual() -> Memory {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/graphs.md");
    let text = std::fs::read_to_string(path).expect("the manual is there");
    let blocks = text.split("```ron\n").skip(1).map(|rest| rest.split("```").next().unwrap_or_default());
    let file = |block: &str| {
        let path = block.lines().next().and_then(|line| line.strip_prefix("// ")).expect("a block names its file");
        (path.to_owned(), block.as_bytes().to_vec())
    };
    Memory(blocks.map(file).collect())
}

#[test]
fn the_manual_shows_a_project_that_works() {
    let files = manual();
    assert_eq!(files.0.len(), 7, "{:?}", files.0.keys());
    let mut sources = Sources::default();
    let library = Library::load(&mut sources, &[]);
    let library = library.unwrap_or_else(|findings| panic!("{}", render(&findings, &sources, false)));
    let opened = Project::with(PathBuf::new(), Box::new(files), library, sources);
    let mut project = opened.unwrap_or_else(|error| panic!("{}", render(&error.diagnostics, &error.sources, false)));
    let findings = project.check_all();
    assert!(
        findings.iter().all(|finding| finding.level == Level::Warning),
        "{}",
        render(&findings, &project.sources, false)
    );
    assert!(findings.is_empty(), "{}", render(&findings, &project.sources, false));
}
