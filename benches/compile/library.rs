//! The node library.

use std::hint::black_box;

use criterion::Criterion;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;

/// Reading it as a whole, and what naga takes of that.
pub(crate) fn load(criterion: &mut Criterion) {
    let load = || Library::load(&mut Sources::default(), &[]).expect("the standard library is sound");
    let library = load();
    println!(
        "library: {} kinds, {} declarations, {} lines of WGSL",
        library.kinds.len(),
        library.items.len(),
        library.text.lines().count()
    );
    let parse = || naga::front::wgsl::parse_str(black_box(&library.text));
    let validate =
        || Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(black_box(&library.module));
    assert!(validate().is_ok(), "naga refuses the library");
    let mut group = criterion.benchmark_group("library");
    group.bench_function("load", |bench| bench.iter(load));
    group.bench_function("naga parses it", |bench| bench.iter(parse));
    group.bench_function("naga validates it", |bench| bench.iter(validate));
    group.finish();
}
