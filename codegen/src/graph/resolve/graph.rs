//! One surface, instance or mask.

use std::collections::BTreeMap;

use super::allow;
use super::call::{Callable, Caller};
use super::images::Images;
use super::order::{Order, order};
use super::output;
use super::port;
use super::scope::{Scope, Target};
use super::texture;
use super::unused::unused;
use super::wire::NodeValue;
use crate::diagnostic::{Diagnostic, any_error};
use crate::graph::file::{Document, Entry, FileRole, GraphFile, NodeEntry};
use crate::graph::model::{Graph, GraphId, Node, Role};
use crate::graph::{codes, suggest};
use crate::library::Library;

/// What a file's kinds mean that are not in the library: an instance, or `None` for one that is wrong.
pub(super) type Instances = BTreeMap<String, Option<GraphId>>;

/// What resolution looks things up in.
#[derive(Clone, Copy)]
pub(super) struct World<'a> {
    pub(super) library: &'a Library,
    pub(super) images: Images<'a>,
    /// Every graph that is resolved already.
    pub(super) graphs: &'a [Graph],
    /// Names of all instances of the project.
    pub(super) known_instances: &'a [String],
}

/// Resolves a file. Nothing comes back if anything in it is wrong.
pub(super) fn graph(
    world: World<'_>,
    document: &Document,
    file: &GraphFile,
    instances: &Instances,
    findings: &mut Vec<Diagnostic>,
) -> Option<Graph> {
    let mut found = Vec::new();
    let mut scope = Scope::new(world.library);
    port::parameters(&mut scope, world.library, &file.parameters, &mut found);
    port::inputs(&mut scope, world.library, &file.inputs, &mut found);
    let textures = texture::textures(&mut scope, world.images, &file.textures, &mut found);
    let order = order(&file.nodes, &mut found);
    for (index, position) in order.positions.iter().enumerate() {
        scope.declare(&file.nodes[*position].name, "node", Target::Node(index), &mut found);
    }
    let images: Vec<_> = textures.iter().map(|declared| declared.texture.clone()).collect();
    let nodes = nodes(world, &mut scope, &images, file, &order, instances, &mut found);
    let outputs = output::outputs(world.library, &scope, file, &mut found);
    let relief = file.relief.as_ref().map(|entry| output::relief(world.library, &scope, &textures, entry, &mut found));
    let allow = allow::allow(file, &mut found);
    let decoded = findings.iter().all(|finding| finding.span().source != document.source);
    let complete = decoded && !any_error(&found) && nodes.len() == file.nodes.len() && !matches!(relief, Some(None));
    let graph = Graph {
        source: document.source,
        path: document.path.clone(),
        name: document.name.clone(),
        role: role(file.role),
        doc: document.doc.clone(),
        inputs: scope.inputs.clone(),
        parameters: scope.parameters.clone(),
        textures: images,
        nodes,
        outputs,
        relief: relief.flatten(),
        allow,
    };
    if complete {
        unused(&graph, &scope, &file.textures, &mut found);
    }
    findings.append(&mut found);
    complete.then_some(graph)
}

fn role(role: FileRole) -> Role {
    match role {
        FileRole::Surface => Role::Surface,
        FileRole::Mask => Role::Mask,
        _ => Role::Instance,
    }
}

fn nodes(
    world: World<'_>,
    scope: &mut Scope<'_>,
    textures: &[crate::graph::model::Texture],
    file: &GraphFile,
    order: &Order,
    instances: &Instances,
    findings: &mut Vec<Diagnostic>,
) -> Vec<Node> {
    let mut nodes = Vec::new();
    for (index, position) in order.positions.iter().enumerate() {
        let entry = &file.nodes[*position];
        let caller = Caller { library: world.library, scope, textures };
        let (node, value) = match callable(world, entry, instances, findings) {
            Some((call, callable)) => caller.node(entry, call, callable, findings),
            None => {
                // What a broken node refers to is used all the same.
                let arguments = entry.value.iter().flat_map(|call| &call.arguments);
                arguments.filter_map(|argument| argument.value.as_ref()).for_each(|expr| {
                    scope.operand(expr, findings);
                });
                (None, NodeValue::Broken)
            }
        };
        scope.values.push(if index < order.sorted { value } else { NodeValue::Broken });
        nodes.extend(node);
    }
    nodes
}

fn callable<'a>(
    world: World<'a>,
    entry: &'a Entry<NodeEntry>,
    instances: &Instances,
    findings: &mut Vec<Diagnostic>,
) -> Option<(&'a NodeEntry, Callable<'a>)> {
    let call = entry.value.as_ref()?;
    let name = &call.kind.name;
    let instance = instances.get(name);
    match (world.library.kinds.get(name), instance) {
        (Some(kind), None) => Some((call, Callable::Kind(kind))),
        // The clash is reported where the instance is looked up.
        (Some(_), Some(_)) => None,
        (None, Some(id)) => id.map(|id| (call, Callable::Instance(id, &world.graphs[id.0]))),
        (None, None) => {
            let kinds = world.library.kinds.keys().map(String::as_str);
            let known = kinds.chain(world.known_instances.iter().map(String::as_str));
            let message = format!("there is no node kind or instance `{name}`");
            let mut finding = Diagnostic::error(codes::UNKNOWN_KIND, call.kind.span, message);
            finding.help = Some(match suggest::nearest(name, known) {
                Some(near) => format!("did you mean `{near}`?"),
                None => "`terrane nodes` lists all kinds; instances are files in graphs/instances/".into(),
            });
            findings.push(finding);
            None
        }
    }
}
