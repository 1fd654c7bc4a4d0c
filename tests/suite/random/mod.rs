//! Random projects that are right: all of them compile, naga and Tint accept what comes out, nothing depends on chance,
//! and what the optimiser leaves has the values of what the graphs say.

mod genes;
mod project;
mod scene;
mod values;

use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestCaseError, TestRunner};
use terrane_codegen::compile::{Compiled, Compiler};
use terrane_codegen::diagnostic::{Sources, render};
use terrane_codegen::graph::{Memory, Project};
use terrane_codegen::library::Library;
use terrane_codegen::program::Options;
use terrane_shaderlib::hosts::{self, Host};

use crate::emitted::layout::groups;
use crate::tint::{Module, Report, Tint};

/// How many projects: the figure that the project promises.
const CASES: u32 = 1000;

/// The library is read once; a project takes it and gives it back.
struct Shelf {
    library: Option<(Library, Sources)>,
}

impl Shelf {
    fn new() -> Self {
        let mut sources = Sources::default();
        let library =
            Library::load(&mut sources, &[]).unwrap_or_else(|found| panic!("{}", render(&found, &sources, false)));
        Self { library: Some((library, sources)) }
    }

    /// Opens the project that the genes describe.
    fn open(&mut self, genes: &[u16]) -> Project {
        let (library, sources) = self.library.take().expect("given back by the last case");
        let files = project::project(&library, genes);
        let memory = files.iter().fold(Memory::default(), |memory, (path, text)| memory.with(path, text.as_str()));
        let project = Project::with(PathBuf::from("/random"), Box::new(memory), library, sources);
        project.unwrap_or_else(|error| panic!("{}", render(&error.diagnostics, &error.sources, false)))
    }

    fn give_back(&mut self, project: Project) {
        self.library = Some((project.library, project.sources));
    }
}

/// The project, compiled; the message says what was wrong with which file.
fn compile(project: &mut Project, host: &Host, options: Options) -> Result<Compiled, String> {
    let (graphs, terrain, _) =
        project.terrain("graphs/terrains/random.ron").map_err(|found| render(&found, &project.sources, false))?;
    let compiler = Compiler { library: &project.library, sources: &project.sources, host, options };
    compiler.terrain(&graphs, &terrain).map_err(|found| render(&found, &project.sources, false))
}

fn check(shelf: &Mutex<Shelf>, host: &Host, tint: Option<&Mutex<Tint>>, genes: &[u16]) -> Result<usize, TestCaseError> {
    let mut shelf = shelf.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let mut project = shelf.open(genes);
    let found = compare(&mut project, host, tint);
    let texts = project::project(&project.library, genes);
    shelf.give_back(project);
    found.map_err(|problem| {
        let files: Vec<String> = texts.iter().map(|(path, text)| format!("// {path}\n{text}")).collect();
        TestCaseError::fail(format!("{problem}\n{}", files.join("\n")))
    })
}

fn compare(project: &mut Project, host: &Host, tint: Option<&Mutex<Tint>>) -> Result<usize, String> {
    let first = compile(project, host, Options::default())?;
    let second = compile(project, host, Options::default())?;
    if first.host.text != second.host.text || first.manifest != second.manifest {
        return Err("two runs gave different bytes".into());
    }
    if let Some(tint) = tint {
        judge(&mut tint.lock().unwrap_or_else(std::sync::PoisonError::into_inner), &first)?;
    }
    // Values are compared below the host: what declares `HostFrame` will do.
    let frame = hosts::WGPU_TERRAIN.iter().find(|file| file.path == "wgpu/frame.wgsl").expect("every host has a frame");
    let host = &Host { flat: frame.text.into(), displaced: None };
    let optimised = compile(project, host, Options { guard: false, ..Options::default() })?;
    let plain = compile(project, host, Options::plain())?;
    values::compare(&project.library, &optimised, &plain)
}

/// Tint on the core alone, and on the pipelines of the host: with the automatic layout, and with that of the manifest.
fn judge(tint: &mut Tint, compiled: &Compiled) -> Result<(), String> {
    let core = Module::text_only("core", &compiled.core.text);
    let host = Module::with_pipelines("host", &compiled.host.text);
    assert!(!host.pipelines.is_empty(), "a host has entry points");
    let host = host.with_layouts(&groups(&compiled.checked.module, &compiled.manifest));
    let errors: String = tint.validate(&[core, host]).iter().map(Report::errors).collect();
    if errors.is_empty() { Ok(()) } else { Err(format!("Tint refuses\n{errors}{}", compiled.host.text)) }
}

#[test]
fn random_projects_compile_and_keep_their_values() {
    let tint = Tint::start();
    let tint = match tint {
        Ok(tint) => Some(Mutex::new(tint)),
        Err(skip) => {
            skip.report();
            None
        }
    };
    let shelf = Mutex::new(Shelf::new());
    let host = hosts::terrain();
    let config = Config { cases: CASES, failure_persistence: None, max_shrink_iters: 300, ..Config::default() };
    // The same projects on every machine: a failure is one for everybody.
    let random = proptest::test_runner::TestRng::deterministic_rng(config.rng_algorithm);
    let mut runner = TestRunner::new_with_rng(config, random);
    let compared = AtomicUsize::new(0);
    let outcome = runner.run(&vec(any::<u16>(), 0..1500), |genes| {
        compared.fetch_add(check(&shelf, &host, tint.as_ref(), &genes)?, Ordering::Relaxed);
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
    let compared = compared.into_inner();
    println!("compared {compared} nodes");
    assert!(compared > 10 * CASES as usize, "only {compared} nodes were compared");
}
