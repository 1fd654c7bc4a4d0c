//! The fields of a group, taken one by one: what is unknown, missing or there twice is found on the way.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use super::field::Field;
use super::raw::Raw;
use super::shape::{Key, Shape};
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::{codes, suggest};

/// The fields of `(a: 1, b: 2)` that are not read yet.
#[derive(Debug)]
pub(crate) struct Fields<'a> {
    /// What the group is, with its article: `a texture`.
    pub(crate) what: &'static str,
    /// Where to point at when a field is missing: the name in front, or the bracket.
    pub(crate) place: Span,
    entries: Vec<(Key<'a>, Raw<'a>)>,
    known: Vec<&'static str>,
}

impl<'a> Fields<'a> {
    /// The fields of a value that must be a group without a name.
    pub(crate) fn open(raw: Raw<'a>, what: &'static str, findings: &mut Vec<Diagnostic>) -> Option<Self> {
        match raw.shape() {
            Ok(Shape::Struct(None, entries)) => Some(Self::new(what, bracket(raw), entries, findings)),
            Ok(other) => {
                let message = format!("{what} is a group of fields, this is {}", other.words());
                findings
                    .push(Diagnostic::error(codes::WRONG_SHAPE, raw.span(), message).help("write (name: value, …)"));
                None
            }
            Err(finding) => {
                findings.push(finding);
                None
            }
        }
    }

    /// The fields of a group that is looked at already.
    pub(crate) fn new(
        what: &'static str,
        place: Span,
        entries: Vec<(Key<'a>, Raw<'a>)>,
        findings: &mut Vec<Diagnostic>,
    ) -> Self {
        let mut first = BTreeMap::new();
        let mut unseen = |(key, _): &(Key<'a>, Raw<'a>)| match first.entry(key.name) {
            Entry::Occupied(seen) => {
                findings.push(twice(key.name, key.span, *seen.get()));
                false
            }
            Entry::Vacant(place) => *place.insert(key.span) == key.span,
        };
        let entries = entries.into_iter().filter(|entry| unseen(entry)).collect();
        Self { what, place, entries, known: Vec::new() }
    }

    /// A field, if it is there.
    pub(crate) fn take(&mut self, name: &'static str) -> Option<Field<'a>> {
        self.known.push(name);
        let index = self.entries.iter().position(|(key, _)| key.name == name)?;
        let (key, raw) = self.entries.remove(index);
        Some(Field { name: key.name, name_span: key.span, raw })
    }

    /// A field that must be there.
    pub(crate) fn need(&mut self, name: &'static str, findings: &mut Vec<Diagnostic>) -> Option<Field<'a>> {
        let field = self.take(name);
        if field.is_none() {
            let message = format!("{} has no `{name}`", self.what);
            findings
                .push(Diagnostic::error(codes::MISSING_FIELD, self.place, message).help(format!("add `{name}: …`")));
        }
        field
    }

    /// All fields that nobody took yet, in the order of the file.
    pub(crate) fn rest(&mut self) -> Vec<Field<'a>> {
        let field = |(key, raw): (Key<'a>, Raw<'a>)| Field { name: key.name, name_span: key.span, raw };
        self.entries.drain(..).map(field).collect()
    }

    /// Every field that nobody took is unknown.
    pub(crate) fn close(self, findings: &mut Vec<Diagnostic>) {
        for (key, _) in &self.entries {
            let message = format!("{} has no field `{}`", self.what, key.name);
            let mut finding = Diagnostic::error(codes::UNKNOWN_FIELD, key.span, message);
            finding.help = suggest::help(key.name, self.known.iter().copied());
            findings.push(finding);
        }
    }
}

/// Two equal keys.
pub(crate) fn twice(name: &str, span: Span, first: Span) -> Diagnostic {
    Diagnostic::error(codes::DUPLICATE_KEY, span, format!("`{name}` is given twice"))
        .label("the second one")
        .also(first, "the first one")
        .help("delete or rename one of them")
}

/// The first byte of a value.
fn bracket(raw: Raw<'_>) -> Span {
    let span = raw.span();
    Span { end: (span.start + 1).min(span.end), ..span }
}
