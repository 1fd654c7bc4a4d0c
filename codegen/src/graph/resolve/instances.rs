//! The instances that a file calls, resolved before it.

use std::collections::BTreeMap;

use super::graph::Instances;
use super::session::Session;
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::file::{Document, GraphFile};
use crate::graph::model::{GraphId, Role};
use crate::graph::{codes, limits};

/// Where instances live.
pub(super) const FOLDER: &str = "graphs/instances";

impl Session<'_> {
    /// Resolves every instance that a file calls, in the order of their names.
    pub(super) fn instances(&mut self, document: &Document, file: &GraphFile) -> Instances {
        let calls = file.nodes.iter().filter_map(|node| node.value.as_ref());
        let mut kinds: BTreeMap<&str, Span> = BTreeMap::new();
        for call in calls.filter(|call| self.known_instances.contains(&call.kind.name)) {
            kinds.entry(&call.kind.name).or_insert(call.kind.span);
        }
        let mut instances = Instances::new();
        for (kind, span) in kinds {
            let path = format!("{FOLDER}/{kind}.ron");
            self.chain.push((document.path.clone(), document.name.clone(), span));
            let id = self.instance(kind, &path, span);
            self.chain.pop();
            instances.insert(kind.to_owned(), id);
        }
        instances
    }

    fn instance(&mut self, kind: &str, path: &str, span: Span) -> Option<GraphId> {
        if self.library.kinds.contains_key(kind) {
            let message = format!("`{kind}` is a node kind, and `{path}` is an instance of the same name");
            let finding = Diagnostic::error(codes::KIND_CLASH, span, message);
            self.findings.push(finding.help("rename the file: its stem is the name that graphs call"));
            return None;
        }
        if let Some(first) = self.chain.iter().position(|(file, ..)| file == path) {
            self.instance_cycle(first);
            return None;
        }
        if self.chain.len() > limits::INCLUDE_DEPTH {
            let message = format!("instances are nested more than {} deep", limits::INCLUDE_DEPTH);
            self.findings.push(Diagnostic::error(codes::LIMIT, span, message));
            return None;
        }
        self.graph_at(path, Role::Instance, span)
    }

    fn instance_cycle(&mut self, first: usize) {
        let mut ring = self.chain[first..].to_vec();
        // The same cycle reads the same, whichever file was looked at first.
        let smallest = (0..ring.len()).min_by_key(|step| ring[*step].1.clone()).unwrap_or(0);
        ring.rotate_left(smallest);
        let names: Vec<String> = ring.iter().chain(&ring[..1]).map(|(_, name, _)| format!("`{name}`")).collect();
        let message = match ring.as_slice() {
            [(_, name, _)] => format!("instance `{name}` calls itself"),
            _ => format!("cycle of instances: {}", names.join(" -> ")),
        };
        let step = |index: usize| (ring[index].2, format!("{} calls {}", names[index], names[index + 1]));
        let (span, text) = step(0);
        let finding = Diagnostic::error(codes::CYCLE, span, message).label(text);
        let finding = (1..ring.len()).map(step).fold(finding, |finding, (span, text)| finding.also(span, text));
        self.findings.push(finding.help("an instance is copied to each of its calls: it cannot contain itself"));
    }
}
