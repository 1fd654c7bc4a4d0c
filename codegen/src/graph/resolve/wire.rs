//! What stands at an input, looked up but not yet fitted to it.

use crate::graph::model::{Access, InputValue};
use crate::graph::syntax::Number;
use crate::value::Type;

/// A value that comes from somewhere else.
#[derive(Clone, Debug)]
pub(super) struct Wire {
    /// From where.
    pub(super) value: InputValue,
    /// Which part of it.
    pub(super) access: Vec<Access>,
    /// What arrives.
    pub(super) ty: Type,
    /// Its unit, where one is known.
    pub(super) unit: Option<String>,
    /// As the author wrote it: `stone.rgb`.
    pub(super) written: String,
}

/// What stands at an input.
#[derive(Clone, Debug)]
pub(super) enum Operand {
    /// A reference.
    Wire(Wire),
    /// One number, or a vector of 2 to 4.
    Numbers(Vec<Number>),
    /// Something that is reported already.
    Broken,
}

impl Operand {
    /// In messages.
    pub(super) fn words(&self) -> String {
        match self {
            Self::Wire(wire) => wire.ty.to_string(),
            Self::Numbers(numbers) => match Type::floats(numbers.len()) {
                Some(Type::F32) | None => "number".into(),
                Some(vector) => vector.to_string(),
            },
            Self::Broken => "?".into(),
        }
    }
}

/// What a node gives.
#[derive(Clone, Debug)]
pub(super) enum NodeValue {
    /// Something that is reported already.
    Broken,
    /// The result of a function.
    Value(Type, Option<String>),
    /// The outputs of an instance: name, type, unit.
    Outputs(Vec<(String, Type, Option<String>)>),
}
