//! The node library: what every node promises, checked for every node without a test written for it.

mod call;
mod documentation;
mod examples;
mod gpu;
mod lattice;
mod noise;
mod normals;
mod ranges;
mod sampling;
mod shadowing;
mod texture;
mod watched;

use std::sync::LazyLock;

use terrane_codegen::diagnostic::{Sources, render};
use terrane_codegen::library::Library;

/// The standard library, read once.
static LIBRARY: LazyLock<Library> = LazyLock::new(|| {
    let mut sources = Sources::default();
    Library::load(&mut sources, &[]).unwrap_or_else(|findings| panic!("{}", render(&findings, &sources, false)))
});
