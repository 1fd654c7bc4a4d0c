//! Nodes, and the wires between them.

use super::{FrameField, GraphId};
use crate::diagnostic::Span;
use crate::value::{Literal, Type};

/// What a node calls.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Callee {
    /// A function of the library, after overload resolution.
    Function {
        /// Kind name.
        kind: String,
        /// Position in [`crate::library::Kind::overloads`].
        overload: usize,
    },
    /// Another graph.
    Instance(GraphId),
}

/// One node.
#[derive(Clone, Debug)]
pub struct Node {
    /// Its name.
    pub name: String,
    /// What it calls.
    pub callee: Callee,
    /// One for each input port of the callee, in its order.
    pub inputs: Vec<Input>,
    /// Component of the result that a texture's `channel` picks.
    pub channel: Option<u8>,
    /// Type of the result, after `channel`. For an instance with several outputs a wire must pick one by path.
    pub ty: Option<Type>,
    /// The whole `"name": kind(…)` entry.
    pub span: Span,
    /// The name alone.
    pub name_span: Span,
}

/// What an input port gets.
#[derive(Clone, Debug)]
pub struct Input {
    /// Where the value comes from.
    pub value: InputValue,
    /// Members and swizzles behind it, in order: `"stone.rgb"` has one.
    pub access: Vec<Access>,
    /// A number that goes to a vector port is spread over so many components.
    pub widen: Option<u8>,
    /// Type at the port, after access and widening.
    pub ty: Type,
    /// The argument in the file; the node's name for defaults.
    pub span: Span,
}

/// Where a value comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum InputValue {
    /// Written in the graph.
    Literal(Literal),
    /// The port's default.
    Default(Literal),
    /// Result of a node, by position in [`Graph::nodes`](super::Graph::nodes).
    Node(usize),
    /// Output of an instance node.
    NodeOutput {
        /// Position in [`Graph::nodes`](super::Graph::nodes).
        node: usize,
        /// Output of the instance.
        output: String,
    },
    /// From the host.
    Frame(FrameField),
    /// Position in [`Graph::parameters`](super::Graph::parameters).
    Parameter(usize),
    /// Position in [`Graph::inputs`](super::Graph::inputs).
    InstanceInput(usize),
    /// Position in [`Graph::textures`](super::Graph::textures); only at texture ports.
    Texture(usize),
}

/// A step from a value to a part of it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Access {
    /// Member of a struct.
    Member(String),
    /// One to four of `xyzw`, in letters `xyzw` whatever the author wrote.
    Swizzle(String),
}

impl Access {
    /// As it is written behind the dot.
    pub fn name(&self) -> &str {
        match self {
            Self::Member(name) | Self::Swizzle(name) => name,
        }
    }
}
