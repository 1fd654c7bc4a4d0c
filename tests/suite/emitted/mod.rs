//! Tint judges everything that is emitted for the projects in this repository, and creates its pipelines: with the
//! automatic layout, and with the one that the manifest describes.

mod determinism;
pub(crate) mod layout;
mod shared;

use std::path::Path;

use terrane_codegen::compile::{Compiled, Compiler};
use terrane_codegen::diagnostic::{Diagnostic, Sources, render};
use terrane_codegen::graph::model::{ReliefMethod, ReliefTrace, Terrain};
use terrane_codegen::graph::{FileRole, Project};
use terrane_codegen::program::Options;
use terrane_shaderlib::hosts::{self, Host};
use terrane_shaderlib::relief::{Method, Platform};

use crate::tint::{Module, Report, Tint};

/// Folders with a `terrane.ron`, from the repository's root.
const PROJECTS: [&str; 3] = [".", "examples/build_script", "src/commands/starter"];

/// Every terrain and every surface of a project, with the path of its file.
fn compile_all(folder: &str) -> Vec<(String, Compiled)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut project = Project::open(&root).unwrap_or_else(|error| fail(&error.diagnostics, &error.sources));
    let paths = project.graph_files();
    let compiled = paths.into_iter().filter_map(|path| match compile(&mut project, &path) {
        Ok(compiled) => Some((path, compiled?)),
        Err(found) => fail(&found, &project.sources),
    });
    compiled.collect()
}

fn compile(project: &mut Project, path: &str) -> Result<Option<Compiled>, Vec<Diagnostic>> {
    let host = hosts::terrain();
    match project.role(path) {
        Some(FileRole::Terrain) => {
            let (graphs, terrain, _) = project.terrain(path)?;
            compiler(project, &host).terrain(&graphs, &terrain).map(Some)
        }
        Some(FileRole::Surface) => {
            let (graphs, surface, _) = project.surface(path)?;
            compiler(project, &host).surface(&graphs, surface, ReliefTrace::ALONE).map(Some)
        }
        _ => Ok(None),
    }
}

fn compiler<'a>(project: &'a Project, host: &'a Host) -> Compiler<'a> {
    Compiler { library: &project.library, sources: &project.sources, host, options: Options::default() }
}

fn fail(found: &[Diagnostic], sources: &Sources) -> ! {
    panic!("{}", render(found, sources, false))
}

fn errors(modules: &[Module]) -> Option<String> {
    match Tint::start() {
        Ok(mut tint) => Some(tint.validate(modules).iter().map(Report::errors).collect()),
        Err(skip) => {
            skip.report();
            None
        }
    }
}

#[test]
fn every_terrain_and_surface_is_accepted_with_the_layout_of_its_manifest() {
    let mut modules = Vec::new();
    for project in PROJECTS {
        let compiled = compile_all(project);
        assert!(!compiled.is_empty(), "{project} has a terrain or a surface");
        for (path, compiled) in compiled {
            let host = Module::with_pipelines(format!("{project}/{path}, host"), &compiled.host.text);
            let layouts = layout::groups(&compiled.checked.module, &compiled.manifest);
            modules.push(host.with_layouts(&layouts));
            modules.push(Module::text_only(format!("{project}/{path}, core"), &compiled.core.text));
        }
    }
    let Some(errors) = errors(&modules) else { return };
    assert_eq!(errors, "");
}

#[test]
fn so_is_a_terrain_with_every_method_of_tracing() {
    let mut project = Project::open(Path::new(env!("CARGO_MANIFEST_DIR"))).expect("the project of this repository");
    let (graphs, terrain, _) = project.terrain("graphs/terrains/yard.ron").expect("a terrain with relief");
    let host = hosts::terrain();
    let traced = |method: Method| {
        let relief = terrain.relief.map(|trace| ReliefTrace { method: ReliefMethod::Fixed(method), ..trace });
        let compiled = compiler(&project, &host).terrain(&graphs, &Terrain { relief, ..terrain.clone() });
        let compiled = compiled.unwrap_or_else(|found| fail(&found, &project.sources));
        let layouts = layout::groups(&compiled.checked.module, &compiled.manifest);
        Module::with_pipelines(method.to_string(), &compiled.host.text).with_layouts(&layouts)
    };
    let Some(errors) = errors(&Method::all().into_iter().map(traced).collect::<Vec<_>>()) else { return };
    assert_eq!(errors, "");
}

#[test]
fn auto_is_the_fastest_exact_method_of_the_platform_and_binds_what_it_reads() {
    let mut project = Project::open(Path::new(env!("CARGO_MANIFEST_DIR"))).expect("the project of this repository");
    let (graphs, terrain, _) = project.terrain("graphs/terrains/yard.ron").expect("a terrain with relief");
    let host = hosts::terrain();
    for (platform, method, bounds) in [(Platform::Gpu, "leap", "_cells"), (Platform::Cpu, "walk", "_bounds")] {
        let options = Options { platform, ..Options::default() };
        let compiled = Compiler { options, ..compiler(&project, &host) }.terrain(&graphs, &terrain);
        let manifest = compiled.unwrap_or_else(|found| fail(&found, &project.sources)).manifest;
        let relief = manifest.relief.expect("the yard has relief");
        assert_eq!(relief.method, method);
        let textures = relief.arrays.iter().flat_map(|array| &array.textures);
        let read: Vec<bool> = textures.map(|texture| texture.name.ends_with(bounds)).collect();
        assert!(read.contains(&true), "{method} without {bounds}");
    }
}

#[test]
fn so_is_a_terrain_with_objects_on_it() {
    let mut project = Project::open(Path::new(env!("CARGO_MANIFEST_DIR"))).expect("the project of this repository");
    let host = hosts::furnished();
    let furnished = ["graphs/terrains/yard.ron", "graphs/terrains/alpine.ron"].map(|path| {
        let (graphs, terrain, _) = project.terrain(path).expect("a terrain");
        let compiled = compiler(&project, &host).terrain(&graphs, &terrain);
        let compiled = compiled.unwrap_or_else(|found| fail(&found, &project.sources));
        let layouts = layout::groups(&compiled.checked.module, &compiled.manifest);
        Module::with_pipelines(path, &compiled.host.text).with_layouts(&layouts)
    });
    let Some(errors) = errors(&furnished) else { return };
    assert_eq!(errors, "");
}

#[test]
fn so_is_relief_in_the_picture_of_a_surface() {
    let mut project = Project::open(Path::new(env!("CARGO_MANIFEST_DIR"))).expect("the project of this repository");
    let (graphs, surface, _) = project.surface("graphs/surfaces/slabs.ron").expect("a surface with relief");
    let host = hosts::preview();
    let compiled = compiler(&project, &host).surface(&graphs, surface, ReliefTrace::ALONE);
    let compiled = compiled.unwrap_or_else(|found| fail(&found, &project.sources));
    assert!(compiled.host.text.contains("terrane_displace"), "no relief");
    let layouts = layout::groups(&compiled.checked.module, &compiled.manifest);
    let module = Module::with_pipelines("slabs", &compiled.host.text).with_layouts(&layouts);
    let Some(errors) = errors(&[module]) else { return };
    assert_eq!(errors, "");
}

#[test]
fn a_manifest_that_forgets_a_texture_is_found_out() {
    let (path, mut compiled) = compile_all("examples/build_script").swap_remove(0);
    let forgotten = compiled.manifest.textures.pop().expect("the sand has textures");
    let host = Module::with_pipelines(path, &compiled.host.text);
    let layouts = layout::groups(&compiled.checked.module, &compiled.manifest);
    let Some(errors) = errors(&[host.with_layouts(&layouts)]) else { return };
    assert!(errors.contains("explicit layout") && !errors.contains("auto layout"), "{errors}");
    assert!(errors.contains(&format!("@group(1) @binding({})", forgotten.binding)), "{errors}");
}

#[test]
fn the_renderers_own_shaders_are_accepted() {
    let shaders = [("sky", hosts::WGPU_SKY), ("resolve", hosts::WGPU_RESOLVE)];
    let modules = shaders.map(|(name, files)| Module::with_pipelines(name, hosts::join(files)));
    assert!(modules.iter().all(|module| !module.pipelines.is_empty()));
    let Some(errors) = errors(&modules) else { return };
    assert_eq!(errors, "");
}
