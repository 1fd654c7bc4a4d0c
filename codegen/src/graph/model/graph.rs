//! One file of a graph: a surface, an instance or a mask.

use std::collections::BTreeMap;

use super::{Input, InstanceInput, Node, Parameter, Relief, Texture};
use crate::diagnostic::{SourceId, Span};
use crate::value::Type;

/// Position in [`Graphs::graphs`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct GraphId(pub usize);

/// Every graph that a terrain or a surface needs, instances before their users.
#[derive(Clone, Debug, Default)]
pub struct Graphs {
    /// Each file once, whatever number of users it has.
    pub graphs: Vec<Graph>,
}

/// What a graph is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// One material.
    Surface,
    /// A sub-graph, used like a kind.
    Instance,
    /// One number, 0..1, that says where a layer lies.
    Mask,
}

/// One surface, instance or mask file.
#[derive(Clone, Debug)]
pub struct Graph {
    /// The file.
    pub source: SourceId,
    /// Project-relative path of the file.
    pub path: String,
    /// File stem.
    pub name: String,
    /// What it is for.
    pub role: Role,
    /// What the author says of it.
    pub doc: String,
    /// Instances only.
    pub inputs: Vec<InstanceInput>,
    /// Surfaces and masks only. Sorted by name.
    pub parameters: Vec<Parameter>,
    /// Sorted by name.
    pub textures: Vec<Texture>,
    /// In dependency order, ties by name: the order in the file does not matter.
    pub nodes: Vec<Node>,
    /// By name. Surfaces: [`SURFACE_OUTPUTS`]; masks: `mask`; instances: free.
    pub outputs: BTreeMap<String, Output>,
    /// Surfaces only.
    pub relief: Option<Relief>,
    /// What a lint rule is not to find, by the name of the node.
    pub allow: BTreeMap<String, Allowed>,
}

/// An exception from a lint rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Allowed {
    /// Name of the rule; whether it exists is the linter's business.
    pub rule: String,
    /// Why it does not hold here; never empty.
    pub reason: String,
    /// The node's name in the exception.
    pub span: Span,
}

/// The outputs of a surface: name, number of components, default where one exists.
pub const SURFACE_OUTPUTS: &[(&str, Type, Option<&[f32]>)] = &[
    ("mask", Type::F32, Some(&[1.0])),
    ("albedo", Type::Vec3, None),
    ("normal", Type::Vec3, Some(&[0.0, 0.0, 1.0])),
    ("roughness", Type::F32, Some(&[0.9])),
    ("metallic", Type::F32, Some(&[0.0])),
    ("occlusion", Type::F32, Some(&[1.0])),
    ("height", Type::F32, Some(&[0.5])),
    ("emissive", Type::Vec3, Some(&[0.0, 0.0, 0.0])),
];

/// An output of a graph.
#[derive(Clone, Debug)]
pub struct Output {
    /// The value.
    pub input: Input,
    /// Its unit, where one is known.
    pub unit: Option<String>,
    /// The name in the file.
    pub span: Span,
}
