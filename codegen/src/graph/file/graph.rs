//! Surfaces, instances and masks as they are written.

use super::expr::{self, Expr};
use super::port::{INPUT_KINDS, PARAMETER_KINDS, PortEntry, port};
use super::texture::{TextureEntry, texture};
use super::{Entry, FileRole, Named};
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::syntax::{Field, Fields, Number, Shape};
use crate::graph::{codes, limits, names, suggest};

/// A surface, an instance or a mask.
#[derive(Clone, Debug)]
pub(crate) struct GraphFile {
    pub(crate) role: FileRole,
    pub(crate) inputs: Vec<Entry<PortEntry>>,
    pub(crate) parameters: Vec<Entry<PortEntry>>,
    pub(crate) textures: Vec<Entry<TextureEntry>>,
    pub(crate) nodes: Vec<Entry<NodeEntry>>,
    pub(crate) outputs: Vec<Entry<Expr>>,
    pub(crate) relief: Option<Entry<ReliefEntry>>,
    pub(crate) allow: Vec<AllowEntry>,
    /// Where to point at when an output is missing.
    pub(crate) outputs_place: Span,
}

/// A call.
#[derive(Clone, Debug)]
pub(crate) struct NodeEntry {
    pub(crate) kind: Named,
    pub(crate) arguments: Vec<Entry<Expr>>,
}

/// `relief: (height: …, uv: …, depth: …)`
#[derive(Clone, Debug)]
pub(crate) struct ReliefEntry {
    pub(crate) height: Expr,
    pub(crate) uv: Expr,
    pub(crate) depth: Number,
}

/// `"node": (rule: …, reason: …)`
#[derive(Clone, Debug)]
pub(crate) struct AllowEntry {
    pub(crate) node: Named,
    /// Rule and reason, unless something is wrong with them.
    pub(crate) value: Option<(String, String)>,
}

/// Reads the fields of a graph.
pub(super) fn read(role: FileRole, fields: &mut Fields<'_>, findings: &mut Vec<Diagnostic>) -> GraphFile {
    let ports = |kinds, field: Option<Field<'_>>, findings: &mut Vec<Diagnostic>| {
        entries(field, findings, |field, findings| port(field, kinds, findings))
    };
    let inputs = if role == FileRole::Instance { fields.take("inputs") } else { None };
    let inputs = ports(&INPUT_KINDS[..], inputs, findings);
    let parameters = if role == FileRole::Instance { None } else { fields.take("parameters") };
    let parameters = ports(&PARAMETER_KINDS[..], parameters, findings);
    let textures = entries(fields.take("textures"), findings, texture);
    let nodes = nodes(fields.take("nodes"), findings);
    let (outputs, relief, outputs_place) = outputs(role, fields, findings);
    let allow = fields.take("allow").map(|field| allow(field, findings)).unwrap_or_default();
    GraphFile { role, inputs, parameters, textures, nodes, outputs, relief, allow, outputs_place }
}

/// The entries of a map whose keys are names of the graph's namespace.
fn entries<'a, T>(
    field: Option<Field<'a>>,
    findings: &mut Vec<Diagnostic>,
    mut read: impl FnMut(Field<'a>, &mut Vec<Diagnostic>) -> Option<T>,
) -> Vec<Entry<T>> {
    let fields = field.map(|field| field.map(findings)).unwrap_or_default();
    let mut entry = |field: Field<'a>| {
        check_name(field.name, field.name_span, findings);
        named(field, read(field, findings))
    };
    fields.into_iter().map(&mut entry).collect()
}

fn named<T>(field: Field<'_>, value: Option<T>) -> Entry<T> {
    // A key lies in quotes; the entry begins with them.
    let quote = field.name_span.start.saturating_sub(1);
    let span = Span { start: quote, end: field.raw.span().end, ..field.name_span };
    Entry { name: Named::new(field.name, field.name_span), span, value }
}

fn check_name(name: &str, span: Span, findings: &mut Vec<Diagnostic>) {
    if name.len() > 64 {
        findings.push(Diagnostic::error(
            codes::LIMIT,
            span,
            format!("a name of {} bytes, the limit is 64", name.len()),
        ));
    } else if !names::is_name(name) {
        findings.push(Diagnostic::error(codes::INVALID_NAME, span, format!("`{name}` is not a name")).help(
            "lower case letters, digits and single `_`, beginning with a letter; not a word of RON such as `true`",
        ));
    }
}

fn nodes(field: Option<Field<'_>>, findings: &mut Vec<Diagnostic>) -> Vec<Entry<NodeEntry>> {
    let place = field.map(|field| field.name_span);
    let nodes = entries(field, findings, node);
    let edges = nodes.iter().filter_map(|node| node.value.as_ref()).map(|node| node.arguments.len()).sum();
    for (count, limit, what) in [(nodes.len(), limits::NODES, "nodes"), (edges, limits::EDGES, "arguments")] {
        if let (true, Some(place)) = (count > limit, place) {
            let message = format!("the file has {count} {what}, the limit is {limit}");
            findings.push(Diagnostic::error(codes::LIMIT, place, message));
            // The names stay known, so that nothing else is said about them.
            return nodes.into_iter().map(|node| Entry { value: None, ..node }).collect();
        }
    }
    nodes
}

fn node(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<NodeEntry> {
    let (kind, entries) = match field.shape(findings)? {
        Shape::Struct(Some(kind), entries) => (kind, entries),
        Shape::Tuple(Some(kind), _) => {
            let message = format!("the arguments of `{}` have no names", kind.name);
            let help = format!("write {}(name: value, …)", kind.name);
            findings.push(Diagnostic::error(codes::UNNAMED_ARGUMENT, kind.span, message).help(help));
            return None;
        }
        Shape::Name(kind) => {
            let message = format!("node `{}` is a name, it should be a call", field.name);
            let help = format!("write {kind}(…), or use `{kind}` directly where `{}` is used", field.name);
            findings.push(Diagnostic::error(codes::WRONG_SHAPE, field.raw.span(), message).help(help));
            return None;
        }
        other => {
            field.wrong(&other, "a call such as ramp(x: slope, low: 0.2, high: 0.6)", findings);
            return None;
        }
    };
    let mut fields = Fields::new("a node", kind.span, entries, findings);
    let arguments = fields.rest().into_iter().map(|field| argument(field, findings)).collect();
    Some(NodeEntry { kind: Named::new(kind.name, kind.span), arguments })
}

fn argument(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Entry<Expr> {
    let span = Span { end: field.raw.span().end, ..field.name_span };
    Entry { name: Named::new(field.name, field.name_span), span, value: expr::read(field, findings) }
}

type Outputs = (Vec<Entry<Expr>>, Option<Entry<ReliefEntry>>, Span);

fn outputs(role: FileRole, fields: &mut Fields<'_>, findings: &mut Vec<Diagnostic>) -> Outputs {
    if role == FileRole::Mask {
        let output = fields.need("output", findings);
        let place = output.map_or(fields.place, |field| field.name_span);
        let mask = output.map(|field| {
            let entry = argument(field, findings);
            Entry { name: Named::new("mask", entry.name.span), ..entry }
        });
        return (mask.into_iter().collect(), None, place);
    }
    let Some(field) = fields.need("outputs", findings) else { return (Vec::new(), None, fields.place) };
    let Some(mut group) = Fields::open(field.raw, "`outputs`", findings) else {
        return (Vec::new(), None, field.name_span);
    };
    let relief = if role == FileRole::Surface { group.take("relief") } else { None };
    let relief = relief.map(|field| {
        let span = Span { end: field.raw.span().end, ..field.name_span };
        Entry { name: Named::new(field.name, field.name_span), span, value: self::relief(field, findings) }
    });
    let outputs = group.rest().into_iter().map(|field| argument(field, findings)).collect();
    (outputs, relief, field.name_span)
}

fn relief(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<ReliefEntry> {
    let mut fields = Fields::open(field.raw, "`relief`", findings)?;
    let height = fields.need("height", findings).and_then(|field| expr::read(field, findings));
    let uv = fields.need("uv", findings).and_then(|field| expr::read(field, findings));
    let depth = fields.need("depth", findings).and_then(|field| field.digits(findings));
    fields.close(findings);
    Some(ReliefEntry { height: height?, uv: uv?, depth: depth? })
}

/// What the author wants to keep although a lint rule finds it.
fn allow(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Vec<AllowEntry> {
    let fields = field.map(findings);
    let entry = |field: Field<'_>| {
        let node = Named::new(field.name, field.name_span);
        AllowEntry { node, value: exception(field, findings) }
    };
    fields.into_iter().map(entry).collect()
}

fn exception(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<(String, String)> {
    let mut fields = Fields::open(field.raw, "an exception", findings)?;
    let help = "write the name of the rule that finds the node";
    let rule = fields.need("rule", findings).and_then(|field| filled(field, help, findings));
    let help = "say why the rule does not hold here: the next reader will want to know";
    let reason = fields.need("reason", findings).and_then(|field| filled(field, help, findings));
    fields.close(findings);
    rule.zip(reason)
}

/// A text that says something.
fn filled(field: Field<'_>, help: &str, findings: &mut Vec<Diagnostic>) -> Option<String> {
    let text = field.text(findings)?;
    if text.trim().is_empty() {
        let message = format!("an exception has an empty `{}`", field.name);
        findings.push(Diagnostic::error(codes::MISSING_FIELD, field.raw.span(), message).help(help));
        return None;
    }
    Some(text)
}

/// An output that does not exist.
pub(crate) fn unknown_output(name: &Named, known: &[&str]) -> Diagnostic {
    let mut finding =
        Diagnostic::error(codes::UNKNOWN_FIELD, name.span, format!("a surface has no output `{}`", name.name));
    finding.help = suggest::help(&name.name, known.iter().copied());
    finding
}
