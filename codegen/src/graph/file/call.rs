//! Settings that are a word or a word with fields: `over`, `height_soft(band: 0.15)`.

use super::Named;
use crate::diagnostic::Diagnostic;
use crate::graph::syntax::{Field, Fields, Raw, Shape};

/// A word and what stands in the brackets behind it.
pub(super) struct Call<'a> {
    /// The word.
    pub(super) name: Named,
    /// Named values.
    pub(super) fields: Fields<'a>,
    /// Values without a name.
    pub(super) items: Vec<Raw<'a>>,
}

/// Reads a setting. `what` names it with its article, for messages about its fields.
pub(super) fn call<'a>(field: Field<'a>, what: &'static str, findings: &mut Vec<Diagnostic>) -> Option<Call<'a>> {
    let (name, span, entries, items) = match field.shape(findings)? {
        Shape::Name(name) => (name, field.raw.span(), Vec::new(), Vec::new()),
        Shape::Struct(Some(key), entries) => (key.name, key.span, entries, Vec::new()),
        Shape::Tuple(Some(key), items) => (key.name, key.span, Vec::new(), items),
        other => {
            field.wrong(&other, "a word, with fields in brackets where it has any", findings);
            return None;
        }
    };
    Some(Call { name: Named::new(name, span), fields: Fields::new(what, span, entries, findings), items })
}

impl<'a> Call<'a> {
    /// The one value in brackets.
    pub(super) fn only(&self, field: Field<'a>, example: &str, findings: &mut Vec<Diagnostic>) -> Option<Field<'a>> {
        if let [raw] = self.items[..] {
            return Some(Field { raw, ..field });
        }
        let message = format!("`{}` takes one value", self.name.name);
        let code = crate::graph::codes::WRONG_SHAPE;
        findings.push(Diagnostic::error(code, field.raw.span(), message).help(format!("write {example}")));
        None
    }

    /// Refuses values without a name.
    pub(super) fn close(self, findings: &mut Vec<Diagnostic>) {
        if let Some(first) = self.items.first() {
            let message = format!("`{}` is given a value without a name", self.name.name);
            findings.push(Diagnostic::error(crate::graph::codes::UNNAMED_ARGUMENT, first.span(), message));
        }
        self.fields.close(findings);
    }
}
