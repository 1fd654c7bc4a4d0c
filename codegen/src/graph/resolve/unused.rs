//! What is declared and has no effect.

use std::collections::BTreeSet;

use super::scope::Scope;
use crate::diagnostic::{Code, Diagnostic, Span};
use crate::graph::codes;
use crate::graph::file::{Entry, TextureEntry};
use crate::graph::model::{Graph, Input, InputValue};

/// Warns of every node that no output depends on, and of every declaration that nothing refers to.
pub(super) fn unused(
    graph: &Graph,
    scope: &Scope<'_>,
    textures: &[Entry<TextureEntry>],
    findings: &mut Vec<Diagnostic>,
) {
    let mut reached = BTreeSet::new();
    let outputs = graph.outputs.values().map(|output| &output.input);
    let mut waiting: Vec<usize> =
        outputs.chain(graph.relief.iter().map(|relief| &relief.uv)).filter_map(node).collect();
    while let Some(index) = waiting.pop() {
        if reached.insert(index) {
            waiting.extend(graph.nodes[index].inputs.iter().filter_map(node));
        }
    }
    let mut warn = |code: Code, span: Span, message: String, help: &str| {
        findings.push(Diagnostic::warning(code, span, message).help(help));
    };
    for (_, node) in graph.nodes.iter().enumerate().filter(|(index, _)| !reached.contains(index)) {
        let message = format!("no output depends on node `{}`", node.name);
        warn(codes::UNUSED_NODE, node.name_span, message, "delete it, or wire it to an output");
    }
    let used = scope.used.borrow();
    for parameter in graph.parameters.iter().filter(|parameter| !used.contains(&parameter.name)) {
        let message = format!("nothing reads parameter `{}`", parameter.name);
        warn(codes::UNUSED_PARAMETER, parameter.span, message, "delete it, or use it in a node");
    }
    for input in graph.inputs.iter().filter(|input| !used.contains(&input.name)) {
        let message = format!("nothing reads input `{}`", input.name);
        warn(codes::UNUSED_INPUT, input.span, message, "delete it, or use it in a node");
    }
    for entry in textures {
        // Members of a set stand at the set's name.
        let mut names = graph.textures.iter().filter(|texture| texture.span == entry.name.span);
        if !names.any(|texture| used.contains(&texture.name)) {
            let message = format!("nothing reads texture `{}`", entry.name.name);
            warn(codes::UNUSED_TEXTURE, entry.name.span, message, "delete it, or read it in a node");
        }
    }
}

fn node(input: &Input) -> Option<usize> {
    match input.value {
        InputValue::Node(node) | InputValue::NodeOutput { node, .. } => Some(node),
        _ => None,
    }
}
