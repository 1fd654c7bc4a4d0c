//! Dependency order of nodes, and the cycles that forbid one.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Span};
use crate::graph::codes;
use crate::graph::file::{Entry, NodeEntry, Value};

/// Positions in the file, dependencies first, ties by name; nodes on or behind a cycle last.
pub(super) struct Order {
    /// Every node once.
    pub(super) positions: Vec<usize>,
    /// How many of them have an order.
    pub(super) sorted: usize,
}

/// The nodes that a node reads, with the place where it does.
type Edges = Vec<BTreeMap<usize, Span>>;

/// Sorts the nodes of a file.
pub(super) fn order(nodes: &[Entry<NodeEntry>], findings: &mut Vec<Diagnostic>) -> Order {
    let edges = edges(nodes);
    let mut readers: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    for (reader, reads) in edges.iter().enumerate() {
        reads.keys().for_each(|read| readers[*read].push(reader));
    }
    let mut waiting: Vec<usize> = edges.iter().map(BTreeMap::len).collect();
    let name = |node: usize| (nodes[node].name.name.as_str(), node);
    let mut ready: BTreeSet<(&str, usize)> = (0..nodes.len()).filter(|node| waiting[*node] == 0).map(name).collect();
    let mut positions = Vec::with_capacity(nodes.len());
    while let Some((_, node)) = ready.pop_first() {
        positions.push(node);
        for reader in &readers[node] {
            waiting[*reader] -= 1;
            if waiting[*reader] == 0 {
                ready.insert(name(*reader));
            }
        }
    }
    let sorted = positions.len();
    let rest: BTreeSet<(&str, usize)> = (0..nodes.len()).filter(|node| waiting[*node] > 0).map(name).collect();
    let rest: Vec<usize> = rest.into_iter().map(|(_, node)| node).collect();
    cycles(nodes, &edges, &rest, findings);
    positions.extend(rest);
    Order { positions, sorted }
}

fn edges(nodes: &[Entry<NodeEntry>]) -> Edges {
    let by_name: BTreeMap<&str, usize> =
        nodes.iter().enumerate().map(|(index, node)| (node.name.name.as_str(), index)).collect();
    let reads = |node: &Entry<NodeEntry>| {
        let arguments =
            node.value.iter().flat_map(|node| &node.arguments).filter_map(|argument| argument.value.as_ref());
        let target = |expr: &crate::graph::file::Expr| match &expr.value {
            Value::Path(path) => by_name.get(path[0].name.as_str()).map(|node| (*node, expr.span)),
            Value::Number(_) | Value::Tuple(_) => None,
        };
        arguments.filter_map(target).collect()
    };
    nodes.iter().map(reads).collect()
}

/// Every node of `rest` reads another one of it, so that a walk along first reads must come back to itself.
fn cycles(nodes: &[Entry<NodeEntry>], edges: &Edges, rest: &[usize], findings: &mut Vec<Diagnostic>) {
    let inside: BTreeSet<usize> = rest.iter().copied().collect();
    let mut seen = BTreeSet::new();
    let next = |node: usize| {
        let reads = edges[node].keys().filter(|read| inside.contains(read));
        reads.min_by_key(|read| &nodes[**read].name.name).copied()
    };
    for start in rest {
        let mut walk = Vec::new();
        let mut node = Some(*start);
        while let Some(at) = node.filter(|at| seen.insert(*at)) {
            walk.push(at);
            node = next(at);
        }
        let entry = walk.iter().position(|at| Some(*at) == node);
        if let Some(entry) = entry {
            findings.push(cycle(nodes, edges, &walk[entry..]));
        }
    }
}

fn cycle(nodes: &[Entry<NodeEntry>], edges: &Edges, walk: &[usize]) -> Diagnostic {
    let name = |node: usize| nodes[node].name.name.as_str();
    let first = (0..walk.len()).min_by_key(|at| name(walk[*at])).unwrap_or(0);
    let ring: Vec<usize> = walk[first..].iter().chain(&walk[..=first]).copied().collect();
    let path: Vec<String> = ring.iter().map(|node| format!("`{}`", name(*node))).collect();
    let step = |pair: &[usize]| (edges[pair[0]][&pair[1]], format!("`{}` reads `{}`", name(pair[0]), name(pair[1])));
    let mut steps = ring.windows(2).map(step);
    let (span, text) = steps.next().unwrap_or((nodes[ring[0]].name.span, String::new()));
    let message = if path.len() == 2 {
        format!("{} depends on itself", path[0])
    } else {
        format!("cycle: {}", path.join(" -> "))
    };
    let finding = Diagnostic::error(codes::CYCLE, span, message).label(text);
    steps.take(8).fold(finding, |finding, (span, text)| finding.also(span, text))
}
