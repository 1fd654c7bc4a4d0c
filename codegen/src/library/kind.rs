//! What a node kind is: derived from a WGSL file, never declared beside it.

use crate::diagnostic::Span;
use crate::value::{Literal, Type};

/// A node kind: one WGSL file, or the overloads in it.
#[derive(Clone, Debug)]
pub struct Kind {
    /// File stem: the name in graphs.
    pub name: String,
    /// Folder: `blend`.
    pub category: String,
    /// First sentence of the file's `//!` lines.
    pub summary: String,
    /// All `//!` lines but the source.
    pub doc: String,
    /// The `//! Source:` line: where it comes from.
    pub source: String,
    /// One for a plain node; several for `add_f32`, `add_vec3` ….
    pub overloads: Vec<Overload>,
    /// The `/// f(…) == value +- tolerance` lines.
    pub examples: Vec<Example>,
}

/// One function of a kind.
#[derive(Clone, Debug)]
pub struct Overload {
    /// The WGSL function: the stem, or the stem and a type suffix.
    pub function: String,
    /// The function's own `///` prose.
    pub doc: String,
    /// In the order of the signature, without the companions of texture ports.
    pub inputs: Vec<Port>,
    /// The result. Its `name` is empty.
    pub output: Port,
    /// The members of a returned struct, with their own docs and ranges; empty for other results.
    pub members: Vec<Port>,
    /// Where the function's name stands in the library text.
    pub span: Span,
}

/// An input or output of a kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Port {
    /// Name in WGSL and in graphs.
    pub name: String,
    /// Type from naga.
    pub ty: Type,
    /// One sentence.
    pub doc: String,
    /// `m`, `rad`, `1/m` …; `None` for plain numbers.
    pub unit: Option<String>,
    /// Inclusive; applies to every component.
    pub range: Option<(f32, f32)>,
    /// What an unconnected input gets.
    pub default: Option<Literal>,
    /// Must be a literal in the graph.
    pub constant: bool,
}

/// An executable claim in a node's documentation.
#[derive(Clone, Debug)]
pub struct Example {
    /// A WGSL expression that calls the node.
    pub call: String,
    /// A WGSL expression of the same type.
    pub expected: String,
    /// Largest difference of any component.
    pub tolerance: f64,
    /// The line in the library text.
    pub span: Span,
}
