//! The one namespace of a graph: frame fields, parameters, inputs, textures, nodes.

use std::cell::RefCell;
use std::collections::btree_map::Entry as Place;
use std::collections::{BTreeMap, BTreeSet};

use super::access;
use super::wire::{NodeValue, Operand, Wire};
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::file::{Expr, Named, Value};
use crate::graph::model::{FrameField, InputValue, InstanceInput, Parameter};
use crate::graph::{codes, suggest};
use crate::library::Library;
use crate::value::Type;

/// What a name means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// From the host.
    Frame(FrameField),
    /// Position among the parameters.
    Parameter(usize),
    /// Position among the inputs.
    Input(usize),
    /// Position among the textures.
    Texture(usize),
    /// A set of textures is not one: the names of its members.
    Set(Vec<String>),
    /// Position among the nodes, in dependency order.
    Node(usize),
    /// Declared, and wrong.
    Broken,
}

/// Who has a name: what it is, in words, and where it stands.
type Declaration = (Target, &'static str, Option<Span>);

/// Everything that a reference can mean, and what is known of it.
pub(super) struct Scope<'a> {
    library: &'a Library,
    names: BTreeMap<String, Declaration>,
    pub(super) parameters: Vec<Parameter>,
    pub(super) inputs: Vec<InstanceInput>,
    /// By dependency order, as far as they are resolved.
    pub(super) values: Vec<NodeValue>,
    /// Names that something refers to.
    pub(super) used: RefCell<BTreeSet<String>>,
}

impl<'a> Scope<'a> {
    /// A scope with the frame fields in it.
    pub(super) fn new(library: &'a Library) -> Self {
        let frame = FrameField::ALL.iter();
        let names =
            frame.map(|(field, name, _)| ((*name).to_owned(), (Target::Frame(*field), "frame field", None))).collect();
        let (parameters, inputs, values) = (Vec::new(), Vec::new(), Vec::new());
        Self { library, names, parameters, inputs, values, used: RefCell::default() }
    }

    /// Declares a name. The first one keeps it.
    pub(super) fn declare(&mut self, name: &Named, what: &'static str, target: Target, findings: &mut Vec<Diagnostic>) {
        match self.names.entry(name.name.clone()) {
            Place::Vacant(place) => {
                place.insert((target, what, Some(name.span)));
            }
            Place::Occupied(first) => {
                let (_, other, place) = first.get();
                let message = format!("{what} `{}` has the name of a {other}", name.name);
                let finding = Diagnostic::error(codes::SHADOWING, name.span, message)
                    .help("frame fields, parameters, inputs, textures and nodes share one namespace: rename it");
                findings.push(match place {
                    Some(span) => finding.also(*span, format!("the {other}")),
                    None => finding,
                });
            }
        }
    }

    /// What a name means.
    pub(super) fn target(&self, name: &str) -> Option<&Target> {
        let found = self.names.get(name).map(|(target, ..)| target);
        if found.is_some() {
            self.used.borrow_mut().insert(name.to_owned());
        }
        found
    }

    /// Looks up what stands at an input.
    pub(super) fn operand(&self, expr: &Expr, findings: &mut Vec<Diagnostic>) -> Operand {
        match &expr.value {
            Value::Number(number) => Operand::Numbers(vec![number.clone()]),
            Value::Tuple(numbers) => Operand::Numbers(numbers.clone()),
            // Hints cost time; who has made a hundred mistakes does not read them.
            Value::Path(path) => match self.wire(path, expr.span, findings.len() < 100) {
                Ok(Some(wire)) => Operand::Wire(wire),
                Ok(None) => Operand::Broken,
                Err(finding) => {
                    findings.push(finding);
                    Operand::Broken
                }
            },
        }
    }

    fn wire(&self, path: &[Named], span: Span, hint: bool) -> Result<Option<Wire>, Diagnostic> {
        let (head, mut rest) = (&path[0], &path[1..]);
        let target = self.target(&head.name).ok_or_else(|| self.unknown(head, hint))?;
        let mut wire = match target {
            Target::Broken => return Ok(None),
            Target::Set(members) => return Err(is_a_set(head, members)),
            Target::Frame(field) => frame(*field),
            Target::Parameter(index) => {
                let parameter = &self.parameters[*index];
                plain(InputValue::Parameter(*index), parameter.ty.clone(), parameter.unit.clone())
            }
            Target::Input(index) => {
                let input = &self.inputs[*index];
                plain(InputValue::InstanceInput(*index), input.ty.clone(), input.unit.clone())
            }
            Target::Texture(index) => plain(InputValue::Texture(*index), Type::Texture, None),
            Target::Node(node) => match self.values.get(*node) {
                None | Some(NodeValue::Broken) => return Ok(None),
                Some(NodeValue::Value(ty, unit)) => plain(InputValue::Node(*node), ty.clone(), unit.clone()),
                Some(NodeValue::Outputs(outputs)) => output(*node, outputs, head, &mut rest, span)?,
            },
        };
        for part in rest {
            wire = access::step(self.library, wire, part)?;
        }
        wire.written = path.iter().map(|part| part.name.as_str()).collect::<Vec<_>>().join(".");
        Ok(Some(wire))
    }

    fn unknown(&self, name: &Named, hint: bool) -> Diagnostic {
        let message = format!("nothing here is called `{}`", name.name);
        let mut finding = Diagnostic::error(codes::UNKNOWN_NAME, name.span, message);
        if !hint {
            return finding;
        }
        finding.help = match suggest::nearest(&name.name, self.names.keys().map(String::as_str)) {
            Some(near) => Some(format!("did you mean `{near}`?")),
            None if self.library.kinds.contains_key(&name.name) => {
                Some(format!("`{0}` is a node kind: call it in a node, \"name\": {0}(…), and refer to that", name.name))
            }
            None => {
                self.set_of(&name.name).or_else(|| suggest::help(&name.name, self.names.keys().map(String::as_str)))
            }
        };
        finding
    }

    /// The set of textures that a name looks like a member of.
    fn set_of(&self, name: &str) -> Option<String> {
        let (set, _) = name.rsplit_once('_')?;
        match self.names.get(set) {
            Some((Target::Set(members), ..)) => Some(format!("the set `{set}` has {}", suggest::list(members))),
            _ => None,
        }
    }
}

fn plain(value: InputValue, ty: Type, unit: Option<String>) -> Wire {
    Wire { value, access: Vec::new(), ty, unit, written: String::new() }
}

fn frame(field: FrameField) -> Wire {
    let unit = FrameField::ALL.iter().find(|(each, ..)| *each == field).and_then(|(_, _, unit)| *unit);
    plain(InputValue::Frame(field), field.ty(), unit.map(str::to_owned))
}

fn is_a_set(name: &Named, members: &[String]) -> Diagnostic {
    let message = format!("`{}` is a set of textures, not one of them", name.name);
    Diagnostic::error(codes::TYPE_MISMATCH, name.span, message)
        .help(format!("name a member: {}", suggest::list(members)))
}

/// An output of an instance: named behind the node, or the only one.
fn output(
    node: usize,
    outputs: &[(String, Type, Option<String>)],
    head: &Named,
    rest: &mut &[Named],
    span: Span,
) -> Result<Wire, Diagnostic> {
    let named = rest.first().and_then(|part| outputs.iter().find(|(name, ..)| *name == part.name));
    let (name, ty, unit) = match (named, outputs, rest.first()) {
        (Some(found), ..) => {
            *rest = &rest[1..];
            found
        }
        (None, [only], _) => only,
        (None, _, part) => {
            let names: Vec<&str> = outputs.iter().map(|(name, ..)| name.as_str()).collect();
            let finding = match part {
                Some(part) => {
                    let message = format!("`{}` has no output `{}`", head.name, part.name);
                    Diagnostic::error(codes::BAD_ACCESS, part.span, message)
                }
                None => {
                    let message = format!("`{}` has {} outputs, this does not say which", head.name, outputs.len());
                    Diagnostic::error(codes::AMBIGUOUS_OUTPUT, span, message)
                }
            };
            let example = format!("\"{}.{}\"", head.name, names[0]);
            let help = format!("there is {}: write for instance {example}", suggest::list(&names));
            return Err(finding.help(help));
        }
    };
    Ok(plain(InputValue::NodeOutput { node, output: name.clone() }, ty.clone(), unit.clone()))
}
