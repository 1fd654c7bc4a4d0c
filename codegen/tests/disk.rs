//! Projects on a real disk: where they are found, and what does not leave them.

use std::fs;
use std::path::Path;

use terrane_codegen::diagnostic::render;
use terrane_codegen::graph::{Disk, FileError, Files, OpenError, Project};

const SURFACE: &str = "Surface(version: 1, outputs: ( albedo: 0.5 ))";

fn folder_with(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (path, text) in files {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().expect("it lies in the folder")).expect("a writable folder");
        fs::write(path, text).expect("a writable file");
    }
    folder
}

fn open(path: &Path) -> Project {
    Project::open(path).unwrap_or_else(|error| panic!("{}", shown(&error)))
}

fn shown(error: &OpenError) -> String {
    render(&error.diagnostics, &error.sources, false)
}

#[test]
fn a_project_is_found_from_any_file_in_it() {
    let folder = folder_with(&[("terrane.ron", "Project(version: 1)"), ("graphs/surfaces/plain.ron", SURFACE)]);
    let file = folder.path().join("graphs/surfaces/plain.ron");
    let mut project = open(&file);
    assert_eq!(project.root(), folder.path().canonicalize().expect("it exists"));
    let relative = project.relative(&file).unwrap_or_else(|findings| panic!("{findings:?}"));
    assert_eq!(relative, "graphs/surfaces/plain.ron");
    assert!(project.surface(&relative).is_ok());
}

#[test]
fn without_a_project_file_there_is_a_diagnostic() {
    let folder = folder_with(&[("plain.ron", SURFACE)]);
    let Err(error) = Project::open(folder.path()) else { panic!("a temporary folder lies in no project") };
    let text = shown(&error);
    assert!(text.contains("[TG160 no-project]") && text.contains("terrane new"), "{text}");
}

#[test]
fn a_file_that_a_command_names_may_be_missing_or_outside() {
    let folder = folder_with(&[("terrane.ron", "Project(version: 1)"), ("graphs/surfaces/plain.ron", SURFACE)]);
    let mut project = open(folder.path());
    let findings = project.surface("graphs/surfaces/plane.ron").expect_err("there is none");
    let text = render(&findings, &project.sources, false);
    assert!(text.contains("there is no file `graphs/surfaces/plane.ron`"), "{text}");
    assert!(text.contains("did you mean `graphs/surfaces/plain.ron`?"), "{text}");
    assert!(project.relative(Path::new("/")).is_err());
}

#[test]
fn a_folder_is_no_file() {
    let folder = folder_with(&[("terrane.ron", "Project(version: 1)"), ("graphs/surfaces/odd.ron/inner", "")]);
    let mut project = open(folder.path());
    let findings = project.surface("graphs/surfaces/odd.ron").expect_err("it is a folder");
    let text = render(&findings, &project.sources, false);
    assert!(
        text.contains("[TG102 unreadable-file]: `graphs/surfaces/odd.ron` cannot be read: it is not a file"),
        "{text}"
    );
}

#[cfg(unix)]
#[test]
fn links_out_of_the_project_are_refused() {
    let outside = folder_with(&[("secret.ron", SURFACE), ("folder/deep.ron", SURFACE)]);
    let folder = folder_with(&[("terrane.ron", "Project(version: 1)"), ("graphs/surfaces/plain.ron", SURFACE)]);
    let surfaces = folder.path().join("graphs/surfaces");
    let link = |target: &Path, name: &str| std::os::unix::fs::symlink(target, surfaces.join(name)).expect("links work");
    link(&outside.path().join("secret.ron"), "leak.ron");
    link(&outside.path().join("folder"), "out");
    link(&surfaces.join("plain.ron"), "inner.ron");
    let disk = Disk::new(folder.path()).expect("it exists");
    assert_eq!(disk.read("graphs/surfaces/leak.ron", 100), Err(FileError::Escapes));
    assert_eq!(disk.head("graphs/surfaces/out/deep.ron", 1), Err(FileError::Escapes));
    assert!(disk.list("graphs/surfaces/out").is_empty());
    assert!(disk.read("graphs/surfaces/inner.ron", 100).is_ok(), "a link that stays inside is a file like others");
    let mut project = open(folder.path());
    let findings = project.surface("graphs/surfaces/leak.ron").expect_err("it leaves the project");
    let text = render(&findings, &project.sources, false);
    assert!(text.contains("[TG103 escaping-path]: `graphs/surfaces/leak.ron` leaves the project"), "{text}");
}

#[test]
fn a_projects_own_nodes_join_the_library() {
    let node = "//! Twice.\n//! Source: here.\n\n/// own_twice(1.0) == 2.0 +- 0.0\n/// -> Twice as much.\nfn own_twice(\n    /// What to double.\n    x: f32,\n) -> f32 {\n    return x + x;\n}\n";
    let surface = "Surface(version: 1, nodes: { \"a\": own_twice(x: slope) }, outputs: ( albedo: a ))";
    let folder = folder_with(&[
        ("terrane.ron", "Project(version: 1)"),
        ("nodes/own_twice.wgsl", node),
        ("graphs/surfaces/doubled.ron", surface),
    ]);
    let mut project = open(folder.path());
    assert!(project.library.kinds.contains_key("own_twice"));
    assert!(project.surface("graphs/surfaces/doubled.ron").is_ok());
}

#[test]
fn a_wrong_node_of_the_project_is_reported_with_its_file() {
    let folder = folder_with(&[("terrane.ron", "Project(version: 1)"), ("nodes/own_twice.wgsl", "fn own_twice(")]);
    let Err(error) = Project::open(folder.path()) else { panic!("the node is no WGSL") };
    assert!(shown(&error).contains("nodes/own_twice.wgsl"), "{}", shown(&error));
}

#[test]
fn reading_stops_at_the_limit() {
    let folder = folder_with(&[("terrane.ron", "Project(version: 1)"), ("long.txt", "0123456789")]);
    let disk = Disk::new(folder.path()).expect("it exists");
    assert_eq!(disk.read("long.txt", 9), Err(FileError::TooLarge(10)));
    assert_eq!(disk.read("long.txt", 10), Ok(b"0123456789".to_vec()));
    assert_eq!(disk.head("long.txt", 4), Ok(b"0123".to_vec()));
    assert_eq!(disk.read("none.txt", 9), Err(FileError::Missing));
    assert_eq!(disk.read("long.txt/inner", 9), Err(FileError::Missing));
}
