//! One node: which function it calls, and what each of its inputs gets.

use std::borrow::Cow;

use super::channel::{ignored_channel, texture_channel};
use super::fit::{self, Owner};
use super::scope::Scope;
use super::wire::{NodeValue, Operand};
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::file::{Entry, Expr, Named, NodeEntry};
use crate::graph::model::{Callee, Graph, GraphId, Input, Node, Texture};
use crate::graph::{codes, suggest};
use crate::library::{Kind, Library, Port};
use crate::value::Type;

/// What a node's name in front of the bracket means.
#[derive(Clone, Copy)]
pub(super) enum Callable<'a> {
    /// A kind of the library.
    Kind(&'a Kind),
    /// Another file.
    Instance(GraphId, &'a Graph),
}

/// What a node needs to know of its surroundings.
pub(super) struct Caller<'a> {
    pub(super) library: &'a Library,
    pub(super) scope: &'a Scope<'a>,
    pub(super) textures: &'a [Texture],
}

/// The inputs of one overload.
type Signature<'a> = Cow<'a, [Port]>;

/// An argument with its value looked up.
pub(super) struct Argument<'a> {
    pub(super) name: &'a Named,
    pub(super) operand: Operand,
    pub(super) span: Span,
}

impl Caller<'_> {
    /// Resolves a call. A node comes back even if some input is wrong, as long as its type is known.
    pub(super) fn node(
        &self,
        entry: &Entry<NodeEntry>,
        call: &NodeEntry,
        callable: Callable<'_>,
        findings: &mut Vec<Diagnostic>,
    ) -> (Option<Node>, NodeValue) {
        let arguments: Vec<Argument<'_>> =
            call.arguments.iter().map(|argument| self.argument(argument, findings)).collect();
        let signatures: Vec<Signature<'_>> = match callable {
            Callable::Kind(kind) => kind.overloads.iter().map(|overload| overload.inputs.as_slice().into()).collect(),
            Callable::Instance(_, graph) => vec![graph.inputs.iter().map(super::port::as_port).collect()],
        };
        let (arguments, meant) = known_ports(arguments, &signatures, &call.kind, findings);
        let Some(chosen) = self.choose(&arguments, &signatures, &call.kind, findings) else {
            return (None, NodeValue::Broken);
        };
        let texture = texture_channel(self.textures, &arguments, callable, findings);
        ignored_channel(texture, callable, chosen, findings);
        let unsure =
            signatures.len() > 1 && arguments.iter().any(|argument| matches!(argument.operand, Operand::Broken));
        let inputs = self.inputs(entry, &call.kind, arguments, &signatures[chosen], &meant, findings);
        let (callee, value, channel) = result(callable, chosen, texture);
        let ty = match &value {
            NodeValue::Value(ty, _) => Some(ty.clone()),
            NodeValue::Outputs(outputs) if outputs.len() == 1 => Some(outputs[0].1.clone()),
            _ => None,
        };
        let node = inputs.map(|inputs| Node {
            name: entry.name.name.clone(),
            callee,
            inputs,
            channel,
            ty,
            span: entry.span,
            name_span: entry.name.span,
        });
        (node, if unsure { NodeValue::Broken } else { value })
    }

    fn argument<'e>(&self, argument: &'e Entry<Expr>, findings: &mut Vec<Diagnostic>) -> Argument<'e> {
        let (operand, span) = match &argument.value {
            Some(expr) => (self.scope.operand(expr, findings), expr.span),
            None => (Operand::Broken, argument.span),
        };
        Argument { name: &argument.name, operand, span }
    }

    /// The overload that takes the arguments with the least widening; the first of equals.
    fn choose(
        &self,
        arguments: &[Argument<'_>],
        signatures: &[Signature<'_>],
        kind: &Named,
        findings: &mut Vec<Diagnostic>,
    ) -> Option<usize> {
        let distance = |ports: &Signature<'_>| {
            let one = |argument: &Argument<'_>| {
                let port = ports.iter().find(|port| port.name == argument.name.name)?;
                fit::distance(&argument.operand, &port.ty)
            };
            arguments.iter().map(one).sum::<Option<u32>>()
        };
        let best = signatures.iter().enumerate().filter_map(|(index, ports)| Some((distance(ports)?, index))).min();
        match (best, signatures) {
            (Some((_, index)), _) => Some(index),
            // Each input says itself what is wrong with it.
            (None, [_]) => Some(0),
            (None, _) => {
                findings.push(no_overload(arguments, signatures, kind));
                None
            }
        }
    }

    fn inputs(
        &self,
        entry: &Entry<NodeEntry>,
        kind: &Named,
        mut arguments: Vec<Argument<'_>>,
        ports: &[Port],
        meant: &[String],
        findings: &mut Vec<Diagnostic>,
    ) -> Option<Vec<Input>> {
        let mut missing = Vec::new();
        let mut inputs = Vec::new();
        for port in ports {
            let index = arguments.iter().position(|argument| argument.name.name == port.name);
            let input = match index.map(|index| arguments.swap_remove(index)) {
                Some(argument) => self.input(argument, port, &kind.name, findings),
                None => fit::default(port, entry.name.span).or_else(|| {
                    missing.push(port);
                    None
                }),
            };
            inputs.push(input);
        }
        // What is misspelt is not missing as well.
        missing.retain(|port| !meant.contains(&port.name));
        if !missing.is_empty() {
            findings.push(missing_inputs(kind, &missing));
        }
        inputs.into_iter().collect()
    }

    fn input(&self, argument: Argument<'_>, port: &Port, kind: &str, findings: &mut Vec<Diagnostic>) -> Option<Input> {
        let owner = Owner::Kind(kind);
        if port.constant && matches!(argument.operand, Operand::Wire(_)) {
            findings.push(fit::not_constant(port, owner, argument.span));
            return None;
        }
        if fit::distance(&argument.operand, &port.ty).is_some() {
            return fit::input(argument.operand, port, owner, argument.span, findings);
        }
        findings.push(fit::mismatch(self.library, &argument.operand, port, owner, argument.span));
        None
    }
}

/// Drops the arguments that no overload takes, with a finding for each; and gives the ports that they may have meant.
fn known_ports<'a>(
    arguments: Vec<Argument<'a>>,
    signatures: &[Signature<'_>],
    kind: &Named,
    findings: &mut Vec<Diagnostic>,
) -> (Vec<Argument<'a>>, Vec<String>) {
    let mut meant = Vec::new();
    let mut names: Vec<&str> =
        signatures.iter().flat_map(|ports| ports.iter()).map(|port| port.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let is_known = |argument: &Argument<'_>| {
        let known = names.contains(&argument.name.name.as_str());
        if !known {
            let message = format!("`{}` has no input `{}`", kind.name, argument.name.name);
            let mut finding = Diagnostic::error(codes::UNKNOWN_PORT, argument.name.span, message);
            finding.help = suggest::help(&argument.name.name, names.iter().copied());
            meant.extend(suggest::nearest(&argument.name.name, names.iter().copied()).map(str::to_owned));
            findings.push(finding);
        }
        known
    };
    let arguments = arguments.into_iter().filter(is_known).collect();
    (arguments, meant)
}

fn missing_inputs(kind: &Named, missing: &[&Port]) -> Diagnostic {
    let names: Vec<&str> = missing.iter().map(|port| port.name.as_str()).collect();
    let message = format!("`{}` does not get {}", kind.name, suggest::list(&names));
    let wanted = |port: &&Port| {
        let doc = if port.doc.is_empty() { String::new() } else { format!(": {}", port.doc) };
        format!("`{}` is {}{doc}", port.name, port.ty)
    };
    let help: Vec<String> = missing.iter().map(wanted).collect();
    Diagnostic::error(codes::MISSING_INPUT, kind.span, message).help(help.join("\n"))
}

fn no_overload(arguments: &[Argument<'_>], signatures: &[Signature<'_>], kind: &Named) -> Diagnostic {
    let given: Vec<String> =
        arguments.iter().map(|argument| format!("{}: {}", argument.name.name, argument.operand.words())).collect();
    let message = format!("no `{}` takes ({})", kind.name, given.join(", "));
    let signature = |ports: &Signature<'_>| {
        let ports: Vec<String> = ports.iter().map(|port| format!("{}: {}", port.name, port.ty)).collect();
        format!("{}({})", kind.name, ports.join(", "))
    };
    let known: Vec<String> = signatures.iter().map(signature).collect();
    let finding = Diagnostic::error(codes::NO_OVERLOAD, kind.span, message);
    let finding = finding.help(format!("there is\n{}", known.join("\n")));
    arguments.iter().fold(finding, |finding, argument| finding.also(argument.span, argument.operand.words()))
}

fn result(callable: Callable<'_>, overload: usize, texture: Option<(u8, Span)>) -> (Callee, NodeValue, Option<u8>) {
    match callable {
        Callable::Kind(kind) => {
            let output = &kind.overloads[overload].output;
            let channel = texture.filter(|_| output.ty == Type::Vec4).map(|(channel, _)| channel);
            let ty = if channel.is_some() { Type::F32 } else { output.ty.clone() };
            let callee = Callee::Function { kind: kind.name.clone(), overload };
            (callee, NodeValue::Value(ty, output.unit.clone()), channel)
        }
        Callable::Instance(id, graph) => {
            let output = |(name, output): (&String, &crate::graph::model::Output)| {
                (name.clone(), output.input.ty.clone(), output.unit.clone())
            };
            (Callee::Instance(id), NodeValue::Outputs(graph.outputs.iter().map(output).collect()), None)
        }
    }
}
