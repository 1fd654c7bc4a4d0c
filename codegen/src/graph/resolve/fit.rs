//! A value meets a port: exact types first, then a number spread over a vector.

use super::wire::{Operand, Wire};
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::codes;
use crate::graph::model::{Input, InputValue};
use crate::graph::syntax::{Number, to_f32, to_i32, to_u32};
use crate::library::{Library, Port};
use crate::value::{Literal, Type};

/// How far a value is from a type: 0 is exact, `None` does not fit.
pub(super) fn distance(operand: &Operand, ty: &Type) -> Option<u32> {
    let is_vector = matches!(ty, Type::Vec2 | Type::Vec3 | Type::Vec4);
    match operand {
        Operand::Broken => Some(0),
        Operand::Wire(wire) if wire.ty == *ty => Some(0),
        Operand::Wire(wire) => (wire.ty == Type::F32 && is_vector).then_some(1),
        Operand::Numbers(numbers) => match (numbers.as_slice(), ty) {
            ([_], Type::F32) => Some(0),
            ([number], Type::I32 | Type::U32) => Some(if number.is_whole() { 1 } else { 8 }),
            ([_], _) => is_vector.then_some(1),
            (many, ty) => (Type::floats(many.len()).as_ref() == Some(ty)).then_some(0),
        },
    }
}

/// The input that a port gets, for a value that fits its type; with whatever else is wrong about it.
pub(super) fn input(
    operand: Operand,
    port: &Port,
    owner: Owner<'_>,
    span: Span,
    findings: &mut Vec<Diagnostic>,
) -> Option<Input> {
    match operand {
        Operand::Broken => None,
        Operand::Wire(wire) => {
            wire_findings(&wire, port, owner, span, findings);
            let widen = if wire.ty == port.ty { None } else { port.ty.components().map(|count| count as u8) };
            Some(Input { value: wire.value, access: wire.access, widen, ty: port.ty.clone(), span })
        }
        Operand::Numbers(numbers) => {
            let literal = literal(&numbers, &port.ty).map_err(|finding| findings.push(finding)).ok()?;
            check_range(&numbers, port, owner, findings);
            let value = InputValue::Literal(literal);
            Some(Input { value, access: Vec::new(), widen: None, ty: port.ty.clone(), span })
        }
    }
}

/// The default of a port that is not connected.
pub(super) fn default(port: &Port, span: Span) -> Option<Input> {
    let value = InputValue::Default(port.default?);
    Some(Input { value, access: Vec::new(), widen: None, ty: port.ty.clone(), span })
}

/// Numbers as a constant of a type; one number fills every component.
///
/// # Errors
/// If the type cannot hold them.
pub(super) fn literal(numbers: &[Number], ty: &Type) -> Result<Literal, Diagnostic> {
    match (ty, numbers) {
        (Type::I32, [number]) => to_i32(number).map(Literal::I32),
        (Type::U32, [number]) => to_u32(number).map(Literal::U32),
        (_, [number]) => {
            let value = to_f32(number)?;
            Ok(Literal::floats(&vec![value; ty.components().unwrap_or(1)]))
        }
        _ => Ok(Literal::floats(&numbers.iter().map(to_f32).collect::<Result<Vec<f32>, _>>()?)),
    }
}

fn wire_findings(wire: &Wire, port: &Port, owner: Owner<'_>, span: Span, findings: &mut Vec<Diagnostic>) {
    let input = described(port, owner);
    if let (Some(given), Some(wanted)) = (&wire.unit, &port.unit)
        && given != wanted
    {
        let message = format!("{input} is in {wanted}, this is in {given}");
        findings.push(Diagnostic::error(codes::UNIT_MISMATCH, span, message).help("convert it, or wire another value"));
    }
}

/// Reports every number outside the port's range.
pub(super) fn check_range(numbers: &[Number], port: &Port, owner: Owner<'_>, findings: &mut Vec<Diagnostic>) {
    let Some((low, high)) = port.range else { return };
    for number in numbers {
        let value = number.value as f32;
        if !(low..=high).contains(&value) {
            let unit = port.unit.as_ref().map(|unit| format!(" {unit}")).unwrap_or_default();
            let range = match (low, high) {
                (low, f32::MAX) => format!("it should be at least {low}{unit}"),
                (f32::MIN, high) => format!("it should be at most {high}{unit}"),
                (low, high) => format!("its range is {low}..{high}{unit}"),
            };
            let message = format!("{} is {}, {range}", described(port, owner), number.text);
            findings.push(Diagnostic::error(codes::OUT_OF_RANGE, number.span, message));
        }
    }
}

/// Whose port it is, for messages.
#[derive(Clone, Copy, Debug)]
pub(super) enum Owner<'a> {
    /// An input of a kind or an instance.
    Kind(&'a str),
    /// An output of the graph itself.
    Graph,
    /// A parameter that a layer sets.
    Layer,
    /// A default in the file.
    Default,
}

fn described(port: &Port, owner: Owner<'_>) -> String {
    match owner {
        Owner::Kind(kind) => format!("input `{}` of `{kind}`", port.name),
        Owner::Graph => format!("output `{}`", port.name),
        Owner::Layer => format!("parameter `{}`", port.name),
        Owner::Default => format!("the default of `{}`", port.name),
    }
}

/// A value where only a number can stand.
pub(super) fn not_constant(port: &Port, owner: Owner<'_>, span: Span) -> Diagnostic {
    let message = format!("{} is wired, it must be a number", described(port, owner));
    Diagnostic::error(codes::CONST_PORT, span, message)
        .help("it shapes the code, such as a loop count: write the number itself")
}

/// A value of the wrong type.
pub(super) fn mismatch(library: &Library, operand: &Operand, port: &Port, owner: Owner<'_>, span: Span) -> Diagnostic {
    let message = format!("{} takes {}, this is {}", described(port, owner), article(&port.ty), a(&operand.words()));
    let mut finding = Diagnostic::error(codes::TYPE_MISMATCH, span, message);
    finding.help = advice(library, operand, &port.ty);
    finding
}

fn article(ty: &Type) -> String {
    a(&ty.to_string())
}

fn a(noun: &str) -> String {
    format!("{} {noun}", if noun.starts_with(['f', 'i', 'a', 'e', 'o']) { "an" } else { "a" })
}

/// What the author may have meant.
fn advice(library: &Library, operand: &Operand, wanted: &Type) -> Option<String> {
    let Operand::Wire(wire) = operand else {
        return matches!(wanted, Type::Struct(_) | Type::Texture).then(|| givers(library, wanted)).flatten();
    };
    match (&wire.ty, wanted) {
        (Type::Vec2 | Type::Vec3 | Type::Vec4, Type::F32) => {
            Some(format!("pick one component: \"{}.x\"", wire.written))
        }
        (Type::Vec3 | Type::Vec4, Type::Vec2) => Some(format!("pick two components: \"{}.xy\"", wire.written)),
        (Type::Vec4, Type::Vec3) => Some(format!("pick three components: \"{}.rgb\"", wire.written)),
        (Type::Texture, _) => {
            Some("a texture is not a value: read it with a node such as texture(of: …, uv: …)".into())
        }
        (Type::Struct(name), _) => members(library, wire, name, wanted).or_else(|| givers(library, wanted)),
        _ => givers(library, wanted),
    }
}

fn members(library: &Library, wire: &Wire, name: &str, wanted: &Type) -> Option<String> {
    let members = library.structs.get(name)?.iter().filter(|member| member.ty == *wanted);
    let names: Vec<String> = members.map(|member| format!("\"{}.{}\"", wire.written, member.name)).collect();
    (!names.is_empty()).then(|| format!("pick a member: {}", names.join(" or ")))
}

/// Kinds whose result is of a struct type.
fn givers(library: &Library, wanted: &Type) -> Option<String> {
    if *wanted == Type::Texture {
        return Some("declare it under `textures`, and refer to it by its name".into());
    }
    let Type::Struct(_) = wanted else { return None };
    let gives = |kind: &&crate::library::Kind| kind.overloads.iter().any(|overload| overload.output.ty == *wanted);
    let names: Vec<&str> = library.kinds.values().filter(gives).map(|kind| kind.name.as_str()).collect();
    let frame = crate::graph::model::FrameField::ALL.iter().filter(|(field, ..)| field.ty() == *wanted);
    let names: Vec<&str> = frame.map(|(_, name, _)| *name).chain(names).collect();
    (!names.is_empty()).then(|| format!("a {wanted} comes from {}", crate::graph::suggest::list(&names)))
}
