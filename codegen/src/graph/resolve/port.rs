//! Parameters and inputs of a graph.

use super::fit::{self, Owner};
use super::scope::{Scope, Target};
use super::wire::Operand;
use crate::diagnostic::Diagnostic;
use crate::graph::codes;
use crate::graph::file::{Entry, Expr, PortEntry, PortKind, Value};
use crate::graph::model::{InstanceInput, Parameter};
use crate::library::{Library, Port};
use crate::value::{Literal, Type};

/// Declares the parameters, sorted by name.
pub(super) fn parameters(
    scope: &mut Scope<'_>,
    library: &Library,
    entries: &[Entry<PortEntry>],
    findings: &mut Vec<Diagnostic>,
) {
    for entry in sorted(entries) {
        let parameter = entry.value.as_ref().and_then(|port| parameter(library, entry, port, findings));
        let target = match parameter {
            Some(parameter) => {
                scope.parameters.push(parameter);
                Target::Parameter(scope.parameters.len() - 1)
            }
            None => Target::Broken,
        };
        scope.declare(&entry.name, "parameter", target, findings);
    }
}

/// Declares the inputs of an instance, sorted by name.
pub(super) fn inputs(
    scope: &mut Scope<'_>,
    library: &Library,
    entries: &[Entry<PortEntry>],
    findings: &mut Vec<Diagnostic>,
) {
    for entry in sorted(entries) {
        let input = entry.value.as_ref().and_then(|port| input(library, entry, port, findings));
        let target = match input {
            Some(input) => {
                scope.inputs.push(input);
                Target::Input(scope.inputs.len() - 1)
            }
            None => Target::Broken,
        };
        scope.declare(&entry.name, "input", target, findings);
    }
}

/// The order in a file must not matter.
pub(super) fn sorted<T>(entries: &[Entry<T>]) -> Vec<&Entry<T>> {
    let mut sorted: Vec<&Entry<T>> = entries.iter().collect();
    sorted.sort_by(|a, b| a.name.name.cmp(&b.name.name));
    sorted
}

/// The type that a `kind:` stands for.
fn ty(kind: PortKind) -> Type {
    match kind {
        PortKind::Number => Type::F32,
        PortKind::Vec2 => Type::Vec2,
        PortKind::Vec3 | PortKind::Color => Type::Vec3,
        PortKind::Vec4 => Type::Vec4,
        PortKind::I32 => Type::I32,
        PortKind::U32 => Type::U32,
        PortKind::Place => Type::Struct("Place".into()),
        PortKind::Coord => Type::Struct("Coord".into()),
        PortKind::Texture => Type::Texture,
    }
}

fn parameter(
    library: &Library,
    entry: &Entry<PortEntry>,
    port: &PortEntry,
    findings: &mut Vec<Diagnostic>,
) -> Option<Parameter> {
    let default = default(library, entry, port, port.default.as_ref()?, findings)?;
    Some(Parameter {
        name: entry.name.name.clone(),
        ty: ty(port.kind),
        color: port.kind == PortKind::Color,
        unit: port.unit.clone(),
        range: port.range,
        default,
        doc: port.doc.clone(),
        span: entry.name.span,
    })
}

fn input(
    library: &Library,
    entry: &Entry<PortEntry>,
    port: &PortEntry,
    findings: &mut Vec<Diagnostic>,
) -> Option<InstanceInput> {
    let default = match &port.default {
        Some(expr) => Some(default(library, entry, port, expr, findings)?),
        None => None,
    };
    let (name, span) = (entry.name.name.clone(), entry.name.span);
    Some(InstanceInput { name, ty: ty(port.kind), range: port.range, default, unit: port.unit.clone(), span })
}

/// As a port of a kind, so that a call checks an instance and a function alike.
pub(super) fn as_port(input: &InstanceInput) -> Port {
    Port {
        name: input.name.clone(),
        ty: input.ty.clone(),
        doc: String::new(),
        unit: input.unit.clone(),
        range: input.range,
        default: input.default,
        constant: false,
    }
}

/// As a port of a surface, for what a layer sets.
pub(super) fn of_parameter(parameter: &Parameter) -> Port {
    Port {
        name: parameter.name.clone(),
        ty: parameter.ty.clone(),
        doc: String::new(),
        unit: parameter.unit.clone(),
        range: parameter.range,
        default: None,
        constant: false,
    }
}

fn default(
    library: &Library,
    entry: &Entry<PortEntry>,
    port: &PortEntry,
    expr: &Expr,
    findings: &mut Vec<Diagnostic>,
) -> Option<Literal> {
    let as_port = Port {
        name: entry.name.name.clone(),
        ty: ty(port.kind),
        doc: String::new(),
        unit: port.unit.clone(),
        range: port.range,
        default: None,
        constant: false,
    };
    constant(library, expr, &as_port, Owner::Default, findings)
}

/// A number or vector that must fit a port.
pub(super) fn constant(
    library: &Library,
    expr: &Expr,
    port: &Port,
    owner: Owner<'_>,
    findings: &mut Vec<Diagnostic>,
) -> Option<Literal> {
    let numbers = match &expr.value {
        Value::Number(number) => vec![number.clone()],
        Value::Tuple(numbers) => numbers.clone(),
        Value::Path(_) => {
            let message = format!("`{}` is given a reference, only a number can stand here", port.name);
            findings.push(Diagnostic::error(codes::WRONG_SHAPE, expr.span, message));
            return None;
        }
    };
    let operand = Operand::Numbers(numbers.clone());
    if fit::distance(&operand, &port.ty).is_none() {
        let mut finding = fit::mismatch(library, &operand, port, owner, expr.span);
        if let (Owner::Default, Type::F32) = (owner, &port.ty) {
            finding.help = Some("say what it is: `kind: color`, `kind: vec2`, `kind: vec3` or `kind: vec4`".into());
        }
        findings.push(finding);
        return None;
    }
    fit::check_range(&numbers, port, owner, findings);
    fit::literal(&numbers, &port.ty).map_err(|finding| findings.push(finding)).ok()
}
