//! The repository's own text files.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders that hold what was made or fetched, not written.
const MADE: [&str; 7] = [".git", "node_modules", "out", "shared", "snapshots", "target", "textures"];

/// A text file of the repository.
pub(super) struct File {
    /// From the root, with `/` on every platform.
    pub(super) path: String,
    /// All of it.
    pub(super) text: String,
}

/// The repository's root folder.
pub(super) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every text file with one of these endings, sorted by path.
pub(super) fn with_endings(endings: &[&str]) -> Vec<File> {
    let mut paths = Vec::new();
    collect(root(), &mut paths);
    paths.sort();
    let wanted = paths.into_iter().filter(|path| endings.iter().any(|ending| has_ending(path, ending)));
    let files: Vec<File> = wanted.map(|path| read(&path)).collect();
    assert!(!files.is_empty(), "no {endings:?} under {}: the rule would hold of nothing", root().display());
    files
}

fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|extension| extension == ending)
}

fn read(path: &Path) -> File {
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let relative = path.strip_prefix(root()).expect("collected under the root");
    File { path: relative.to_string_lossy().replace('\\', "/"), text }
}

fn collect(folder: &Path, paths: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of the repository") {
        let path = entry.expect("a readable folder").path();
        let name = path.file_name().expect("an entry has a name").to_string_lossy();
        if path.is_dir() && !MADE.contains(&name.as_ref()) {
            collect(&path, paths);
        } else if path.is_file() {
            paths.push(path);
        }
    }
}
