//! What a graph gives: its outputs and its relief.

use std::collections::BTreeMap;

use super::fit::{self, Owner};
use super::scope::{Scope, Target};
use super::texture::Declared;
use super::wire::Operand;
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::file::{Entry, Expr, FileRole, GraphFile, ReliefEntry, Value, unknown_output};
use crate::graph::model::{ColorSpace, Output, Relief, SURFACE_OUTPUTS, Wrap};
use crate::graph::syntax::within;
use crate::graph::{codes, names};
use crate::library::{Library, Port};
use crate::value::Type;

/// Texels on a side of a relief at most: the bounds of all its mips stand in one texture, twice as high.
const LARGEST: u32 = 4096;
/// Metres of relief at most.
const DEEPEST: f32 = 100.0;

/// Resolves every output; those that are missing or unknown are reported.
pub(super) fn outputs(
    library: &Library,
    scope: &Scope<'_>,
    file: &GraphFile,
    findings: &mut Vec<Diagnostic>,
) -> BTreeMap<String, Output> {
    let mut outputs = BTreeMap::new();
    for entry in &file.outputs {
        let operand = entry.value.as_ref().map(|expr| (expr, scope.operand(expr, findings)));
        let Some((expr, operand)) = operand else { continue };
        let Some(port) = port(file.role, entry, &operand, findings) else { continue };
        let unit = match &operand {
            Operand::Wire(wire) => wire.unit.clone(),
            _ => None,
        };
        if fit::distance(&operand, &port.ty).is_none() {
            findings.push(fit::mismatch(library, &operand, &port, Owner::Graph, expr.span));
        } else if let Some(input) = fit::input(operand, &port, Owner::Graph, expr.span, findings) {
            outputs.insert(port.name, Output { input, unit, span: entry.name.span });
        }
    }
    missing(file, findings);
    outputs
}

/// What an output must be.
fn port(role: FileRole, entry: &Entry<Expr>, operand: &Operand, findings: &mut Vec<Diagnostic>) -> Option<Port> {
    let name = entry.name.name.as_str();
    let (ty, range) = match role {
        FileRole::Surface => {
            let Some((_, ty, _)) = SURFACE_OUTPUTS.iter().find(|(known, ..)| *known == name) else {
                let known: Vec<&str> = SURFACE_OUTPUTS.iter().map(|(known, ..)| *known).chain(["relief"]).collect();
                findings.push(unknown_output(&entry.name, &known));
                return None;
            };
            (ty.clone(), surface_range(name))
        }
        FileRole::Mask => (Type::F32, (0.0, 1.0)),
        _ => {
            if !names::is_name(name) {
                let message = format!("`{name}` is not a name");
                findings.push(Diagnostic::error(codes::INVALID_NAME, entry.name.span, message));
            }
            let ty = match operand {
                Operand::Wire(wire) if wire.ty == Type::Texture => {
                    let message = format!("output `{name}` is a texture, an instance gives values");
                    findings.push(Diagnostic::error(codes::TYPE_MISMATCH, entry.span, message));
                    return None;
                }
                Operand::Wire(wire) => wire.ty.clone(),
                Operand::Numbers(numbers) => Type::floats(numbers.len())?,
                Operand::Broken => return None,
            };
            (ty, (f32::MIN, f32::MAX))
        }
    };
    let range = (range != (f32::MIN, f32::MAX)).then_some(range);
    Some(Port { name: name.into(), ty, doc: String::new(), unit: None, range, default: None, constant: false })
}

/// What a written output may be; a computed one is the linter's business.
fn surface_range(name: &str) -> (f32, f32) {
    match name {
        "normal" => (-1.0, 1.0),
        "emissive" => (0.0, f32::MAX),
        _ => (0.0, 1.0),
    }
}

fn missing(file: &GraphFile, findings: &mut Vec<Diagnostic>) {
    let has = |name: &str| file.outputs.iter().any(|entry| entry.name.name == name);
    let mut report = |message: String, help: &str| {
        findings.push(Diagnostic::error(codes::MISSING_OUTPUT, file.outputs_place, message).help(help));
    };
    match file.role {
        FileRole::Surface => {
            for (name, ty, _) in SURFACE_OUTPUTS.iter().filter(|(name, _, default)| default.is_none() && !has(name)) {
                report(format!("the surface has no `{name}`"), &format!("add `{name}: …`, a {ty}; colours are linear"));
            }
        }
        FileRole::Instance if file.outputs.is_empty() => {
            report("the instance has no output".into(), "add `outputs: ( name: value )`");
        }
        _ => {}
    }
}

/// Resolves `relief: (height: …, uv: …, depth: …)`.
pub(super) fn relief(
    library: &Library,
    scope: &Scope<'_>,
    textures: &[Declared],
    entry: &Entry<ReliefEntry>,
    findings: &mut Vec<Diagnostic>,
) -> Option<Relief> {
    let value = entry.value.as_ref()?;
    let texture = height(scope, textures, &value.height, findings);
    let uv = scope.operand(&value.uv, findings);
    let port = Port {
        name: "uv".into(),
        ty: Type::Struct("Coord".into()),
        doc: String::new(),
        unit: None,
        range: None,
        default: None,
        constant: false,
    };
    let owner = Owner::Kind("relief");
    let uv = if fit::distance(&uv, &port.ty).is_some() {
        fit::input(uv, &port, owner, value.uv.span, findings)
    } else {
        findings.push(fit::mismatch(library, &uv, &port, owner, value.uv.span));
        None
    };
    let depth = within("depth", &value.depth, 0.0001, DEEPEST, findings);
    Some(Relief { texture: texture?, uv: uv?, depth: depth?, span: entry.span })
}

/// A relief's height: one number per texel, because its pyramid is built from the image.
fn height(scope: &Scope<'_>, textures: &[Declared], expr: &Expr, findings: &mut Vec<Diagnostic>) -> Option<usize> {
    let mut refuse = |span: Span, message: &str, help: &str| {
        findings.push(Diagnostic::error(codes::TYPE_MISMATCH, span, message).help(help));
        None
    };
    let target = match &expr.value {
        Value::Path(path) if path.len() == 1 => scope.target(&path[0].name).cloned(),
        _ => {
            return refuse(expr.span, "the height of a relief is not a texture", "write the name of a texture");
        }
    };
    let index = match target {
        Some(Target::Texture(index)) => index,
        Some(Target::Broken) => return None,
        // The scope says what is unknown, and what a set has.
        None | Some(Target::Set(_)) => {
            scope.operand(expr, findings);
            return None;
        }
        Some(_) => {
            let help = "write the name of a texture; a computed height must be saved as an image first";
            return refuse(expr.span, "the height of a relief is not a texture", help);
        }
    };
    let Declared { texture, channels } = &textures[index];
    if texture.color == ColorSpace::Srgb {
        return refuse(expr.span, "the height of a relief is a colour", "heights are `color: linear`");
    }
    if *channels > 1 && texture.channel.is_none() {
        return refuse(expr.span, "the height of a relief has several channels", "choose one: `channel: r`");
    }
    if texture.wrap != Wrap::Repeat {
        return refuse(expr.span, "the height of a relief does not repeat", "heights are `wrap: repeat`, on all sides");
    }
    let (width, height) = texture.size;
    if [width, height].iter().any(|side| !side.is_power_of_two() || *side > LARGEST) {
        let message = format!("the height of a relief is {width}x{height} texels");
        return refuse(expr.span, &message, &format!("its sides are powers of two, {LARGEST} at most"));
    }
    Some(index)
}
