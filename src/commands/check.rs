//! `terrane check`: what is wrong with the graphs, without writing anything.

use std::path::PathBuf;

use terrane_codegen::diagnostic::{Diagnostic, any_error, sort};
use terrane_codegen::graph::model::ReliefTrace;
use terrane_codegen::graph::{FileRole, Project};
use terrane_shaderlib::relief::Platform;

use super::{Failure, project};

/// Find what is wrong with graphs, and have their WGSL judged by naga
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  terrane check\n  terrane check graphs/surfaces/granite.ron graphs/terrains/alpine.ron"
)]
pub(crate) struct Check {
    /// Graph files; the whole project of the working directory if there are none
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,
}

impl Check {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let start = self.files.first().cloned().unwrap_or_else(|| PathBuf::from("."));
        let mut project = project::open(&start)?;
        let mut paths = Vec::new();
        for file in &self.files {
            paths.push(project::relative(&mut project, file)?);
        }
        if paths.is_empty() {
            paths = project.graph_files();
        }
        let mut found: Vec<Diagnostic> = paths.iter().flat_map(|path| check(&mut project, path)).collect();
        sort(&mut found);
        if any_error(&found) {
            return Err(project::findings(&found, &project.sources));
        }
        project::warn(&found, &project.sources);
        println!("{} files are right", paths.len());
        Ok(())
    }
}

/// What resolution finds, and what the generator finds where resolution found no error.
fn check(project: &mut Project, path: &str) -> Vec<Diagnostic> {
    let mut found = project.check(path);
    if !any_error(&found) {
        found.extend(compile(project, path).err().into_iter().flatten());
    }
    found
}

fn compile(project: &mut Project, path: &str) -> Result<(), Vec<Diagnostic>> {
    match project.role(path) {
        Some(FileRole::Terrain) => {
            let (graphs, terrain, _) = project.terrain(path)?;
            project::compiler(project, &project::TERRAIN_HOST, Platform::Gpu).terrain(&graphs, &terrain)?;
        }
        Some(FileRole::Surface) => {
            let (graphs, surface, _) = project.surface(path)?;
            project::compiler(project, &project::TERRAIN_HOST, Platform::Gpu).surface(
                &graphs,
                surface,
                ReliefTrace::ALONE,
            )?;
        }
        _ => {}
    }
    Ok(())
}
