//! The graph in the README compiles. Those in docs/graphs.md make a project, which is tested with the graphs.

use std::fs;
use std::path::PathBuf;

use terrane_codegen::compile::Compiler;
use terrane_codegen::diagnostic::{Diagnostic, Sources, render};
use terrane_codegen::graph::model::ReliefTrace;
use terrane_codegen::graph::{Memory, Project};
use terrane_codegen::library::Library;
use terrane_codegen::program::Options;
use terrane_shaderlib::hosts;

use super::files::root;

#[test]
fn the_surface_in_the_readme_compiles() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let block =
        readme.split_once("```ron\n").and_then(|(_, rest)| rest.split("```").next()).expect("it shows a surface");
    let path = block.lines().next().and_then(|line| line.strip_prefix("// ")).expect("it says which file that is");
    compile(path, block).unwrap_or_else(|report| panic!("{report}"));
}

/// Compiles a surface as the only one of a project.
fn compile(path: &str, text: &str) -> Result<(), String> {
    let mut sources = Sources::default();
    let library = Library::load(&mut sources, &[]).expect("the library is tested elsewhere");
    let files = Memory::default().with("terrane.ron", "Project(version: 1)").with(path, text);
    let project = Project::with(PathBuf::from("/"), Box::new(files), library, sources);
    let mut project = project.map_err(|error| render(&error.diagnostics, &error.sources, false))?;
    compile_in(&mut project, path).map_err(|found| render(&found, &project.sources, false))
}

fn compile_in(project: &mut Project, path: &str) -> Result<(), Vec<Diagnostic>> {
    let (graphs, surface, warnings) = project.surface(path)?;
    if !warnings.is_empty() {
        return Err(warnings);
    }
    let host = hosts::terrain();
    let (library, sources) = (&project.library, &project.sources);
    Compiler { library, sources, host: &host, options: Options::default() }
        .surface(&graphs, surface, ReliefTrace::ALONE)
        .map(drop)
}
