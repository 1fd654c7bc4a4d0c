//! From the graphs of a terrain to WGSL that naga has judged.

use std::path::Path;
use std::sync::LazyLock;

use criterion::{BatchSize, Criterion};
use terrane_codegen::check::check;
use terrane_codegen::compile::Compiler;
use terrane_codegen::emit::{core, host};
use terrane_codegen::graph::Project;
use terrane_codegen::graph::model::{Graphs, Terrain};
use terrane_codegen::manifest::{Parts, manifest};
use terrane_codegen::patch::{Combination, specialize};
use terrane_codegen::program::{Options, Program};
use terrane_shaderlib::hosts;

static HOST: LazyLock<hosts::Host> = LazyLock::new(hosts::terrain);
const TERRAIN: &str = "graphs/terrains/alpine.ron";

fn open() -> Project {
    Project::open(Path::new(env!("CARGO_MANIFEST_DIR"))).unwrap_or_else(|error| panic!("{:?}", error.diagnostics))
}

fn resolve(project: &mut Project) -> (Graphs, Terrain) {
    let (graphs, terrain, _) = project.terrain(TERRAIN).unwrap_or_else(|found| panic!("{found:?}"));
    (graphs, terrain)
}

/// Each stage alone, on the result of those before it.
pub(crate) fn stages(criterion: &mut Criterion) {
    let mut project = open();
    let (graphs, terrain) = resolve(&mut project);
    let (library, sources) = (&project.library, &project.sources);
    let intern = || Program::of_terrain(library, &graphs, &terrain, Options::default());
    let program = intern();
    print_counts(&project, &graphs, &terrain);
    let special = |program: &Program| specialize(program, &Combination::all(program), Options::default());
    let mut kept = program.clone();
    let patch = special(&kept);
    kept.keep(&patch.live);
    let (core_shader, host_shader) = (core(library, &kept, &patch), host(library, &kept, &patch, &HOST.flat));
    let checked = check(&host_shader, library, &kept).expect("naga accepts the terrain");
    let parts = Parts {
        program: &kept,
        patch: &patch,
        core: &core_shader,
        host: &host_shader,
        checked: &checked,
        terrain: Some(&terrain),
    };

    let mut group = criterion.benchmark_group("stage");
    group.bench_function("resolve", |bench| bench.iter_batched_ref(open, resolve, BatchSize::PerIteration));
    group.bench_function("intern", |bench| bench.iter(intern));
    group.bench_function("specialize", |bench| bench.iter(|| special(&program)));
    group.bench_function("emit core", |bench| bench.iter(|| core(library, &kept, &patch)));
    group.bench_function("emit host", |bench| bench.iter(|| host(library, &kept, &patch, &HOST.flat)));
    group.bench_function("check core", |bench| bench.iter(|| check(&core_shader, library, &kept)));
    group.bench_function("check host", |bench| bench.iter(|| check(&host_shader, library, &kept)));
    group.bench_function("manifest", |bench| bench.iter(|| manifest(&parts, sources)));
    group.finish();
}

/// From graph files to checked WGSL and manifest, the library being there.
pub(crate) fn whole(criterion: &mut Criterion) {
    let whole = |project: &mut Project| {
        let (graphs, terrain) = resolve(project);
        compiler(project, Options::default()).terrain(&graphs, &terrain)
    };
    criterion.bench_function("graph to checked WGSL", |bench| {
        bench.iter_batched_ref(open, whole, BatchSize::PerIteration);
    });
}

fn compiler(project: &Project, options: Options) -> Compiler<'_> {
    Compiler { library: &project.library, sources: &project.sources, host: &HOST, options }
}

/// What interning and specialising leave of what the graphs say.
fn print_counts(project: &Project, graphs: &Graphs, terrain: &Terrain) {
    for (name, options) in [("as written", Options::plain()), ("interned", Options::default())] {
        let program = Program::of_terrain(&project.library, graphs, terrain, options);
        let (calls, values) = program.pool.counts();
        let compiled = compiler(project, options).terrain(graphs, terrain).unwrap_or_else(|found| panic!("{found:?}"));
        let lets = compiled.patch.live.iter().filter(|id| !compiled.program.pool.get(**id).is_inline()).count();
        let lines = compiled.core.text.lines().count();
        println!("{TERRAIN}, {name}: {calls} nodes -> {values} values, {lets} of them emitted, core of {lines} lines");
    }
}
