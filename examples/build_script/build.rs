//! Compiles `graphs/terrains/dunes.ron` to WGSL whenever a file that it reads has changed.

use std::path::{Path, PathBuf};
use std::{env, fs, process};

use terrane_codegen::compile::{Compiled, Compiler};
use terrane_codegen::diagnostic::{Diagnostic, Sources, render};
use terrane_codegen::graph::Project;
use terrane_codegen::program::Options;
use terrane_shaderlib::hosts;

fn main() {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let mut project = Project::open(&root).unwrap_or_else(|error| stop(&error.diagnostics, &error.sources));
    let compiled = compile(&mut project).unwrap_or_else(|found| stop(&found, &project.sources));
    watch(&project, &root);
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    fs::write(out.join("terrain.wgsl"), compiled.core.text).expect("OUT_DIR is writable");
    fs::write(out.join("terrain.json"), compiled.manifest.to_json()).expect("OUT_DIR is writable");
}

fn compile(project: &mut Project) -> Result<Compiled, Vec<Diagnostic>> {
    let (graphs, terrain, _) = project.terrain("graphs/terrains/dunes.ron")?;
    let host = hosts::terrain();
    let (library, sources) = (&project.library, &project.sources);
    Compiler { library, sources, host: &host, options: Options::default() }.terrain(&graphs, &terrain)
}

/// The nodes of the library come with the crate; every other file that was read is the project's.
fn watch(project: &Project, root: &Path) {
    let files = project.sources.iter().map(|source| root.join(&source.path)).filter(|path| path.is_file());
    files.for_each(|path| println!("cargo::rerun-if-changed={}", path.display()));
}

/// Reports on the graphs as the compiler reports on code.
fn stop(found: &[Diagnostic], sources: &Sources) -> ! {
    eprint!("{}", render(found, sources, false));
    process::exit(1)
}
