//! Arguments: numbers and references.

use std::borrow::Cow;

use super::Named;
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::syntax::{Field, Number, Raw, Shape};
use crate::graph::{codes, limits, names};

/// What stands at an input.
#[derive(Clone, Debug)]
pub(crate) struct Expr {
    /// What it says.
    pub(crate) value: Value,
    /// Its place, quotes included.
    pub(crate) span: Span,
}

/// A number, several of them, or a reference.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    /// `2.0`
    Number(Number),
    /// `(1.0, 0.0, 0.5)`
    Tuple(Vec<Number>),
    /// `rock` or `"rock.rgb"`: a name, then members and swizzles.
    Path(Vec<Named>),
}

/// Reads what stands at an input.
pub(crate) fn read(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<Expr> {
    let raw = field.raw;
    let value = match field.shape(findings)? {
        Shape::Number(number) => Value::Number(number),
        Shape::Tuple(None, items) => Value::Tuple(numbers(field, &items, findings)?),
        // RON reads these words as numbers.
        Shape::Name(name) => Value::Path(vec![Named::new(name, raw.span())]),
        Shape::Text(text) => Value::Path(path(raw, text, findings)?),
        Shape::Struct(Some(key), _) | Shape::Tuple(Some(key), _) => {
            let message = format!("`{}` is given a call of `{}`", field.name, key.name);
            let help =
                format!("give the call a name among the nodes: \"{}\": {}(…), and refer to it", field.name, key.name);
            findings.push(Diagnostic::error(codes::NESTED_CALL, key.span, message).help(help));
            return None;
        }
        other => {
            field.wrong(&other, "a number, numbers in brackets, or a reference", findings);
            return None;
        }
    };
    Some(Expr { value, span: raw.span() })
}

fn numbers(field: Field<'_>, items: &[Raw<'_>], findings: &mut Vec<Diagnostic>) -> Option<Vec<Number>> {
    if !(2..=4).contains(&items.len()) {
        let message = format!("`{}` has {} parts, a vector has 2 to 4", field.name, items.len());
        findings.push(Diagnostic::error(codes::WRONG_SHAPE, field.raw.span(), message));
        return None;
    }
    let mut numbers = Vec::new();
    for raw in items {
        let part = Field { raw: *raw, ..field };
        match part.shape(findings)? {
            Shape::Number(number) => numbers.push(number),
            other => {
                let message = format!("a part of `{}` is {}, only numbers make a vector", field.name, other.words());
                findings.push(Diagnostic::error(codes::WRONG_SHAPE, raw.span(), message));
                return None;
            }
        }
    }
    Some(numbers)
}

/// `"rock.rgb"`, each part with its own place where the text has no escapes.
fn path(raw: Raw<'_>, text: Cow<'_, str>, findings: &mut Vec<Diagnostic>) -> Option<Vec<Named>> {
    let steps = text.split('.').count();
    if text.len() > limits::STRING_BYTES || steps > limits::STEPS {
        let limit = format!("the limit is {} bytes and {} parts", limits::STRING_BYTES, limits::STEPS);
        let message = format!("a reference of {} bytes in {steps} parts, {limit}", text.len());
        findings.push(Diagnostic::error(codes::LIMIT, raw.span(), message));
        return None;
    }
    let parts: Vec<Named> = match &text {
        Cow::Borrowed(text) => text.split('.').map(|part| Named::new(part, raw.span_of(part))).collect(),
        Cow::Owned(text) => text.split('.').map(|part| Named::new(part, raw.span())).collect(),
    };
    if parts.iter().all(|part| names::is_word(&part.name)) {
        return Some(parts);
    }
    let message = format!("{} is not a reference", raw.text());
    findings.push(
        Diagnostic::error(codes::INVALID_NAME, raw.span(), message)
            .help("write a name, or \"name.member\", or \"name.xyz\""),
    );
    None
}
