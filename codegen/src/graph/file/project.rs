//! `terrane.ron` as it is written.

use super::{Entry, Named};
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::codes;
use crate::graph::syntax::{Field, Fields, Number, Shape};

/// `terrane.ron`.
#[derive(Clone, Debug)]
pub(crate) struct ProjectFile {
    /// By the path that they make.
    pub(crate) made: Vec<Entry<MadeEntry>>,
}

/// A call of a recipe.
#[derive(Clone, Debug)]
pub(crate) struct MadeEntry {
    pub(crate) recipe: Named,
    pub(crate) arguments: Vec<(Named, Number)>,
}

/// Reads the fields of a project.
pub(super) fn read(fields: &mut Fields<'_>, findings: &mut Vec<Diagnostic>) -> ProjectFile {
    let entries = fields.take("made").map(|field| field.map(findings)).unwrap_or_default();
    let made = entries.into_iter().map(|field| {
        let span = Span { end: field.raw.span().end, ..field.name_span };
        Entry { name: Named::new(field.name, field.name_span), span, value: made(field, findings) }
    });
    ProjectFile { made: made.collect() }
}

fn made(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<MadeEntry> {
    let (recipe, entries) = match field.shape(findings)? {
        Shape::Struct(Some(recipe), entries) => (recipe, entries),
        Shape::Tuple(Some(recipe), _) => {
            let message = format!("the arguments of `{}` have no names", recipe.name);
            let help = format!("write {}(name: value, …)", recipe.name);
            findings.push(Diagnostic::error(codes::UNNAMED_ARGUMENT, recipe.span, message).help(help));
            return None;
        }
        other => {
            field.wrong(&other, "a recipe such as mountains(size: 2048, seed: 7)", findings);
            return None;
        }
    };
    let mut fields = Fields::new("a recipe", recipe.span, entries, findings);
    let mut arguments = Vec::new();
    for argument in fields.rest() {
        let name = Named::new(argument.name, argument.name_span);
        arguments.push((name, argument.digits(findings)?));
    }
    Some(MadeEntry { recipe: Named::new(recipe.name, recipe.span), arguments })
}
