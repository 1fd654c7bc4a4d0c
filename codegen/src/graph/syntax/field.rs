//! A value with a name, read as what it must be.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use super::fields::twice;
use super::number::{Number, to_f32, to_u32};
use super::raw::Raw;
use super::shape::Shape;
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::{codes, limits, suggest};

/// A value and the name that it goes by in messages.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Field<'a> {
    /// Name of the field.
    pub(crate) name: &'a str,
    /// Its place.
    pub(crate) name_span: Span,
    /// Its value.
    pub(crate) raw: Raw<'a>,
}

impl<'a> Field<'a> {
    /// What it is, one level deep.
    pub(crate) fn shape(self, findings: &mut Vec<Diagnostic>) -> Option<Shape<'a>> {
        self.raw.shape().map_err(|finding| findings.push(finding)).ok()
    }

    /// Says that something else is expected.
    pub(crate) fn wrong(self, found: &Shape<'_>, expected: &str, findings: &mut Vec<Diagnostic>) {
        let message = format!("`{}` is {}, it should be {expected}", self.name, found.words());
        findings.push(Diagnostic::error(codes::WRONG_SHAPE, self.raw.span(), message));
    }

    /// A text of bounded length.
    pub(crate) fn text(self, findings: &mut Vec<Diagnostic>) -> Option<String> {
        match self.shape(findings)? {
            Shape::Text(text) if text.len() > limits::STRING_BYTES => {
                let message =
                    format!("`{}` is {} bytes long, the limit is {}", self.name, text.len(), limits::STRING_BYTES);
                findings.push(Diagnostic::error(codes::LIMIT, self.name_span, message));
                None
            }
            Shape::Text(text) => Some(text.into_owned()),
            other => {
                self.wrong(&other, "a text in quotes", findings);
                None
            }
        }
    }

    /// A number as it is written.
    pub(crate) fn digits(self, findings: &mut Vec<Diagnostic>) -> Option<Number> {
        match self.shape(findings)? {
            Shape::Number(number) => Some(number),
            other => {
                self.wrong(&other, "a number", findings);
                None
            }
        }
    }

    /// A number within a range.
    pub(crate) fn number(self, low: f32, high: f32, findings: &mut Vec<Diagnostic>) -> Option<f32> {
        let number = self.digits(findings)?;
        within(self.name, &number, low, high, findings)
    }

    /// A whole number within a range.
    pub(crate) fn whole(self, low: u32, high: u32, findings: &mut Vec<Diagnostic>) -> Option<u32> {
        let number = self.digits(findings)?;
        let value = to_u32(&number).map_err(|finding| findings.push(finding)).ok()?;
        if (low..=high).contains(&value) {
            return Some(value);
        }
        findings.push(outside(self.name, &number, &format!("{low}..{high}")));
        None
    }

    /// So many numbers in brackets.
    pub(crate) fn tuple<const N: usize>(self, findings: &mut Vec<Diagnostic>) -> Option<[Field<'a>; N]> {
        let expected = format!("{N} numbers in brackets");
        let items = match self.shape(findings)? {
            Shape::Tuple(None, items) => items,
            other => {
                self.wrong(&other, &expected, findings);
                return None;
            }
        };
        let found = items.len();
        let parts: Vec<Self> = items.into_iter().map(|raw| Field { raw, ..self }).collect();
        let parts = <[Self; N]>::try_from(parts);
        if parts.is_err() {
            let message = format!("`{}` has {found} parts, it should be {expected}", self.name);
            findings.push(Diagnostic::error(codes::WRONG_SHAPE, self.raw.span(), message));
        }
        parts.ok()
    }

    /// So many numbers in brackets, each within a range.
    pub(crate) fn numbers<const N: usize>(
        self,
        low: f32,
        high: f32,
        findings: &mut Vec<Diagnostic>,
    ) -> Option<[f32; N]> {
        let parts = self.tuple::<N>(findings)?.map(|part| part.number(low, high, findings));
        parts.iter().all(Option::is_some).then(|| parts.map(Option::unwrap_or_default))
    }

    /// Lowest and highest value, in this order.
    pub(crate) fn range(self, low: f32, high: f32, findings: &mut Vec<Diagnostic>) -> Option<(f32, f32)> {
        let [first, last] = self.numbers(low, high, findings)?;
        if first < last {
            return Some((first, last));
        }
        let message = format!("`{}` goes from {first} to {last}, the first number should be the lower one", self.name);
        findings.push(Diagnostic::error(codes::OUT_OF_RANGE, self.raw.span(), message));
        None
    }

    /// One of a few words.
    pub(crate) fn choice<T: Copy>(self, words: &[(&str, T)], findings: &mut Vec<Diagnostic>) -> Option<T> {
        let name = match self.shape(findings)? {
            Shape::Name(name) => name,
            other => {
                let names: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
                self.wrong(&other, &format!("one of {}", suggest::list(&names)), findings);
                return None;
            }
        };
        let found = words.iter().find(|(word, _)| *word == name);
        if found.is_none() {
            let names: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
            findings.push(self.unknown_choice(name, &names));
        }
        found.map(|(_, value)| *value)
    }

    /// A word that is none of those that are known.
    pub(crate) fn unknown_choice(self, found: &str, known: &[&str]) -> Diagnostic {
        let one_of = if known.len() == 1 { "" } else { "one of " };
        let message = format!("`{}` is `{found}`, it should be {one_of}{}", self.name, suggest::list(known));
        let finding = Diagnostic::error(codes::UNKNOWN_CHOICE, self.raw.span(), message);
        match suggest::nearest(found, known.iter().copied()) {
            Some(name) => finding.help(format!("did you mean `{name}`?")),
            None => finding,
        }
    }

    /// The entries of `{"name": value}`, each key a name.
    pub(crate) fn map(self, findings: &mut Vec<Diagnostic>) -> Vec<Field<'a>> {
        let entries = match self.shape(findings) {
            Some(Shape::Map(entries)) => entries,
            Some(other) => {
                self.wrong(&other, "a map: {\"name\": value, …}", findings);
                return Vec::new();
            }
            None => return Vec::new(),
        };
        let mut fields: Vec<Field<'a>> = Vec::new();
        let mut first = BTreeMap::new();
        for (key, raw) in entries {
            let Some(field) = entry(key, raw, findings) else { continue };
            match first.entry(field.name) {
                Entry::Occupied(seen) => findings.push(twice(field.name, field.name_span, *seen.get())),
                Entry::Vacant(place) => {
                    place.insert(field.name_span);
                    fields.push(field);
                }
            }
        }
        fields
    }
}

/// A map's entry, if its key is a text without escapes: then the name lies in the file.
fn entry<'a>(key: Raw<'a>, raw: Raw<'a>, findings: &mut Vec<Diagnostic>) -> Option<Field<'a>> {
    match key.shape() {
        Ok(Shape::Text(std::borrow::Cow::Borrowed(name))) => {
            return Some(Field { name, name_span: key.span_of(name), raw });
        }
        Ok(Shape::Text(_)) => {
            findings
                .push(Diagnostic::error(codes::INVALID_NAME, key.span(), "a key has escapes").help("write it plainly"));
        }
        Ok(other) => {
            let message = format!("a key is {}, it should be a name in quotes", other.words());
            findings.push(Diagnostic::error(codes::WRONG_SHAPE, key.span(), message));
        }
        Err(finding) => findings.push(finding),
    }
    None
}

/// A number within a range.
pub(crate) fn within(name: &str, number: &Number, low: f32, high: f32, findings: &mut Vec<Diagnostic>) -> Option<f32> {
    let value = to_f32(number).map_err(|finding| findings.push(finding)).ok()?;
    if (low..=high).contains(&value) {
        return Some(value);
    }
    findings.push(outside(name, number, &format!("{low}..{high}")));
    None
}

fn outside(name: &str, number: &Number, range: &str) -> Diagnostic {
    let message = format!("`{name}` is {}, its range is {range}", number.text);
    Diagnostic::error(codes::OUT_OF_RANGE, number.span, message)
}
