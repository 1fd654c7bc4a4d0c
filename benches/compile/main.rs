//! What compiling costs, stage by stage: `cargo bench --bench compile`.

mod library;
mod terrain;

use criterion::{criterion_group, criterion_main};

criterion_group!(benches, library::load, terrain::stages, terrain::whole);
criterion_main!(benches);
