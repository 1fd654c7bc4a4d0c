//! What every command does with a project: open it, ask it, report on it.

use std::io::IsTerminal as _;
use std::path::Path;
use std::sync::LazyLock;

use terrane_codegen::compile::Compiler;
use terrane_codegen::diagnostic::{Diagnostic, Sources, render};
use terrane_codegen::graph::Project;
use terrane_codegen::program::Options;
use terrane_shaderlib::hosts::{self, Host};
use terrane_shaderlib::relief::Platform;

use super::Failure;

/// The project that a file or folder belongs to.
pub(super) fn open(inside: &Path) -> Result<Project, Failure> {
    Project::open(inside).map_err(|error| findings(&error.diagnostics, &error.sources))
}

/// The project-relative name of a file on the command line.
pub(super) fn relative(project: &mut Project, file: &Path) -> Result<String, Failure> {
    project.relative(file).map_err(|found| findings(&found, &project.sources))
}

/// Findings that stop the command.
pub(super) fn findings(found: &[Diagnostic], sources: &Sources) -> Failure {
    let report = render(found, sources, std::io::stderr().is_terminal());
    Failure::Findings(format!("{report}{}", count(found.len())))
}

fn count(findings: usize) -> String {
    match findings {
        1 => "1 finding".into(),
        more => format!("{more} findings"),
    }
}

/// Findings that do not.
pub(super) fn warn(found: &[Diagnostic], sources: &Sources) {
    eprint!("{}", render(found, sources, std::io::stderr().is_terminal()));
}

/// The plain WebGPU host for terrain.
pub(super) static TERRAIN_HOST: LazyLock<Host> = LazyLock::new(hosts::terrain);

/// The same for terrain with objects on it.
pub(super) static FURNISHED_HOST: LazyLock<Host> = LazyLock::new(hosts::furnished);

/// The host that shows what the search for relief did.
pub(super) static SEARCHED_HOST: LazyLock<Host> = LazyLock::new(hosts::searched);

/// The host that shows one material.
pub(super) static PREVIEW_HOST: LazyLock<Host> = LazyLock::new(hosts::preview);

/// The generator with a host.
pub(super) fn compiler<'a>(project: &'a Project, host: &'a Host, platform: Platform) -> Compiler<'a> {
    let options = Options { platform, ..Options::default() };
    Compiler { library: &project.library, sources: &project.sources, host, options }
}
