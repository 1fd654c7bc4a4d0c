//! What compiling costs, stage by stage: `cargo bench --bench compile`.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;

/// Reading the node library: scanning every file, one parse by naga, and naga's validation of it all.
fn library(criterion: &mut Criterion) {
    let load = || Library::load(&mut Sources::default(), &[]).expect("the standard library is sound");
    let library = load();
    println!("library: {} kinds, {} declarations", library.kinds.len(), library.items.len());
    criterion.bench_function("library/load", |bench| bench.iter(load));
    let text = &library.text;
    criterion
        .bench_function("library/naga parse", |bench| bench.iter(|| naga::front::wgsl::parse_str(black_box(text))));
    let validate = || Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&library.module);
    assert!(validate().is_ok(), "naga refuses the library");
    criterion.bench_function("library/naga validate", |bench| bench.iter(validate));
}

criterion_group!(benches, library);
criterion_main!(benches);
