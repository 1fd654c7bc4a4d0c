//! `docs/graphs.md` shows a project that works, down to the shader.

mod support;

use std::path::{Path, PathBuf};

use terrane_codegen::check::check;
use terrane_codegen::diagnostic::{Sources, render};
use terrane_codegen::emit::core;
use terrane_codegen::graph::model::ReliefTrace;
use terrane_codegen::graph::{Memory, Project};
use terrane_codegen::library::Library;
use terrane_codegen::patch::{Combination, specialize};
use terrane_codegen::program::{Options, Program};

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

fn open(files: Memory) -> Project {
    let mut sources = Sources::default();
    let library = Library::load(&mut sources, &[]);
    let library = library.unwrap_or_else(|findings| panic!("{}", render(&findings, &sources, false)));
    let opened = Project::with(PathBuf::new(), Box::new(files), library, sources);
    opened.unwrap_or_else(|error| panic!("{}", render(&error.diagnostics, &error.sources, false)))
}

fn emitted(library: &Library, mut program: Program) -> String {
    let patch = specialize(&program, &Combination::all(&program), Options::default());
    program.keep(&patch.live);
    let shader = core(library, &program, &patch);
    let checked = check(&shader, library, &program);
    assert!(checked.is_ok(), "{:?}\n{}", checked.err(), shader.text);
    shader.text
}

#[test]
fn the_manual_shows_a_project_that_works() {
    let files = manual();
    assert_eq!(files.0.len(), 7, "{:?}", files.0.keys());
    let mut project = open(files);
    let findings = support::beside_relief(project.check_all());
    assert!(findings.is_empty(), "{}", render(&findings, &project.sources, false));
    let (graphs, scene, _) = project.scene("graphs/scenes/alpine.ron").expect("it is checked");
    emitted(&project.library, Program::of_terrain(&project.library, &graphs, &scene.terrain, Options::default()));
}

#[test]
fn a_texture_that_goes_through_instances_reaches_the_shader() {
    let inner = "Instance(version: 1, inputs: { \"t\": (kind: texture), \"c\": (kind: coord) }, \
        nodes: { \"texel\": texture(of: t, uv: c) }, outputs: ( color: \"texel.rgb\" ))";
    let outer = "Instance(version: 1, inputs: { \"picture\": (kind: texture), \"where\": (kind: place) }, \
        nodes: { \"uv\": planar(position: where), \"i\": inner(t: picture, c: uv) }, outputs: ( color: i, uv: uv ))";
    let surface = "Surface(version: 1, textures: { \"stone\": (file: \"textures/granite_albedo.png\", color: srgb) }, \
        nodes: { \"o\": outer(picture: stone, where: position) }, outputs: ( albedo: \"o.color\", mask: \"o.uv.uv.x\" ))";
    let files = manual()
        .with("graphs/instances/inner.ron", inner)
        .with("graphs/instances/outer.ron", outer)
        .with("graphs/surfaces/user.ron", surface);
    let mut project = open(files);
    let answer = project.surface("graphs/surfaces/user.ron");
    let (graphs, id, warnings) =
        answer.unwrap_or_else(|findings| panic!("{}", render(&findings, &project.sources, false)));
    assert!(warnings.is_empty(), "{warnings:?}");
    let text = emitted(
        &project.library,
        Program::of_surface(&project.library, &graphs, id, ReliefTrace::ALONE, Options::default()),
    );
    assert!(text.contains("textureSampleGrad"), "{text}");
}
