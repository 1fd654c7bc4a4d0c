//! Equal sub-graphs are computed once, whatever they are called and whatever file they come from.

use std::path::{Path, PathBuf};

use terrane_codegen::compile::{Compiled, Compiler};
use terrane_codegen::diagnostic::Sources;
use terrane_codegen::graph::{Memory, Project};
use terrane_codegen::library::Library;
use terrane_codegen::program::Options;
use terrane_shaderlib::hosts;

use super::fail;

const ROOT: &str = r#"Project(version: 1, made: { "textures/land.png": mountains(size: 64, seed: 1) })"#;

const CHALK: &str = r#"Surface(
    version: 1,
    nodes: {
        "grain": fbm(position: position, wavelength: 3.0),
        "stain": contrast(x: grain, amount: 2.0),
        "shade": lerp(a: 0.7, b: 0.9, t: stain),
    },
    outputs: ( albedo: shade, height: grain ),
)"#;

const CLAY: &str = r#"Surface(
    version: 1,
    nodes: {
        "lumps": contrast(amount: 2.0, x: waves),
        "waves": fbm(wavelength: 3.0, position: position),
        "tone": lerp(a: 0.3, b: 0.5, t: lumps),
    },
    outputs: ( albedo: tone, mask: lumps ),
)"#;

const ASH: &str = r#"Surface(
    version: 1,
    nodes: {
        "drift": fbm(position: position, wavelength: 3.0),
        "cover": contrast(x: drift, amount: 2.0),
        "dust": lerp(a: 0.05, b: 0.1, t: cover),
    },
    outputs: ( albedo: dust, mask: cover, roughness: drift ),
)"#;

/// The same by way of an instance.
const MOSS: &str = r#"Surface(
    version: 1,
    nodes: { "patches": clumps(period: 3.0), "green": lerp(a: 0.1, b: 0.2, t: patches) },
    outputs: ( albedo: green, mask: patches ),
)"#;

const CLUMPS: &str = r#"Instance(
    version: 1,
    inputs: { "period": (unit: "m") },
    nodes: { "n": fbm(position: position, wavelength: period), "c": contrast(x: n, amount: 2.0) },
    outputs: ( clumps: c ),
)"#;

const TERRAIN: &str = r#"Terrain(
    version: 1,
    height: (file: "textures/land.png", size: (512.0, 512.0), range: (0.0, 90.0)),
    layers: [
        (surface: "graphs/surfaces/chalk.ron"),
        (surface: "graphs/surfaces/clay.ron"),
        (surface: "graphs/surfaces/ash.ron"),
        (surface: "graphs/surfaces/moss.ron"),
    ],
)"#;

fn four_materials() -> Project {
    let files = [
        ("terrane.ron", ROOT),
        ("graphs/surfaces/chalk.ron", CHALK),
        ("graphs/surfaces/clay.ron", CLAY),
        ("graphs/surfaces/ash.ron", ASH),
        ("graphs/surfaces/moss.ron", MOSS),
        ("graphs/instances/clumps.ron", CLUMPS),
        ("graphs/terrains/tested.ron", TERRAIN),
    ];
    let files = files.iter().fold(Memory::default(), |memory, (path, text)| memory.with(path, *text));
    let mut sources = Sources::default();
    let library = Library::load(&mut sources, &[]).unwrap_or_else(|found| fail(&found, &sources));
    let project = Project::with(PathBuf::from("/"), Box::new(files), library, sources);
    project.unwrap_or_else(|error| fail(&error.diagnostics, &error.sources))
}

fn compile(project: &mut Project, terrain: &str, options: Options) -> Compiled {
    let (graphs, terrain, _) = project.terrain(terrain).unwrap_or_else(|found| fail(&found, &project.sources));
    let host = hosts::terrain();
    let compiler = Compiler { library: &project.library, sources: &project.sources, host: &host, options };
    compiler.terrain(&graphs, &terrain).unwrap_or_else(|found| fail(&found, &project.sources))
}

#[test]
fn a_sub_graph_of_several_materials_appears_once() {
    let mut project = four_materials();
    let mut calls = |options| {
        let core = compile(&mut project, "graphs/terrains/tested.ron", options).core.text;
        ["fbm", "contrast", "lerp_f32"].map(|kind| core.matches(&format!(" = {kind}(")).count())
    };
    assert_eq!(calls(Options::default()), [1, 1, 4], "a lerp of each material differs from the others");
    assert_eq!(calls(Options { intern: false, ..Options::default() }), [4, 4, 4], "once for each material");
}

#[test]
fn interning_leaves_fewer_calls_of_the_alpine_materials() {
    let mut project = Project::open(Path::new(env!("CARGO_MANIFEST_DIR")))
        .unwrap_or_else(|error| fail(&error.diagnostics, &error.sources));
    // Nothing is folded, so that interning alone makes the difference.
    let mut values = |intern| {
        let options = Options { intern, ..Options::plain() };
        compile(&mut project, "graphs/terrains/alpine.ron", options).manifest.permutations[0].values
    };
    let (before, after) = (values(false), values(true));
    println!("{before} calls, {after} after interning");
    assert!(after < before, "{after} of {before} calls are left");
}
