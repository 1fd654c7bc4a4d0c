//! What a graph takes from those who use it, and from those who tweak.

use crate::diagnostic::Span;
use crate::value::{Literal, Type};

/// An input of an instance.
#[derive(Clone, Debug)]
pub struct InstanceInput {
    /// Its name.
    pub name: String,
    /// `kind:` in the file; a number where nothing is said.
    pub ty: Type,
    /// Inclusive.
    pub range: Option<(f32, f32)>,
    /// What an unconnected input gets.
    pub default: Option<Literal>,
    /// Unit.
    pub unit: Option<String>,
    /// The name in the file.
    pub span: Span,
}

/// A value that can be tweaked while the shader runs.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// A number, a vector or a colour.
    pub ty: Type,
    /// Whether the vector is a colour, for a host's user interface.
    pub color: bool,
    /// Unit.
    pub unit: Option<String>,
    /// Inclusive.
    pub range: Option<(f32, f32)>,
    /// The value where nobody tweaks.
    pub default: Literal,
    /// What the author says of it.
    pub doc: String,
    /// The name in the file.
    pub span: Span,
}
