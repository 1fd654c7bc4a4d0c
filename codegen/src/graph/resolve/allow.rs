//! What the author wants to keep although a lint rule finds it.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::Diagnostic;
use crate::graph::file::{AllowEntry, GraphFile};
use crate::graph::model::Allowed;
use crate::graph::{codes, suggest};

/// Every exception by the name of its node; one for a node that does not exist is an exception for nothing.
pub(super) fn allow(file: &GraphFile, findings: &mut Vec<Diagnostic>) -> BTreeMap<String, Allowed> {
    let names: BTreeSet<&str> = file.nodes.iter().map(|node| node.name.name.as_str()).collect();
    let (known, unknown): (Vec<_>, Vec<_>) =
        file.allow.iter().partition(|entry| names.contains(entry.node.name.as_str()));
    findings.extend(unknown.into_iter().map(|entry| no_node(entry, &names)));
    known.into_iter().filter_map(allowed).collect()
}

fn allowed(entry: &AllowEntry) -> Option<(String, Allowed)> {
    let (rule, reason) = entry.value.clone()?;
    Some((entry.node.name.clone(), Allowed { rule, reason, span: entry.node.span }))
}

fn no_node(entry: &AllowEntry, names: &BTreeSet<&str>) -> Diagnostic {
    let name = &entry.node.name;
    let message = format!("an exception for `{name}`, which is no node");
    let mut finding = Diagnostic::error(codes::UNKNOWN_NAME, entry.node.span, message);
    finding.help = suggest::help(name, names.iter().copied());
    finding
}
