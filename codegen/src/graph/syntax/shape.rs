//! What a value is, one level deep.

use std::borrow::Cow;
use std::fmt;

use serde::de::{Deserialize as _, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::number::Number;
use super::raw::{Capture, Raw};
use crate::diagnostic::Span;

/// One value, its parts still raw.
#[derive(Debug)]
pub(crate) enum Shape<'a> {
    /// `0.5`
    Number(Number),
    /// `"text"`; borrowed from the file where it has no escapes.
    Text(Cow<'a, str>),
    /// `srgb`
    Name(&'a str),
    /// `kind(a: 1)` or `(a: 1)`, and `kind()`.
    Struct(Option<Key<'a>>, Vec<(Key<'a>, Raw<'a>)>),
    /// `kind(1, 2)` or `(1, 2)`.
    Tuple(Option<Key<'a>>, Vec<Raw<'a>>),
    /// `[1, 2]`
    List(Vec<Raw<'a>>),
    /// `{"a": 1}`
    Map(Vec<(Raw<'a>, Raw<'a>)>),
    /// Whatever else RON knows, in words.
    Other(&'static str),
}

impl Shape<'_> {
    /// In words.
    pub(crate) fn words(&self) -> &'static str {
        match self {
            Self::Number(_) => "a number",
            Self::Text(_) => "a text",
            Self::Name(_) => "a name",
            Self::Struct(Some(_), _) | Self::Tuple(Some(_), _) => "a call",
            Self::Struct(None, _) => "a group of fields",
            Self::Tuple(None, _) => "a tuple",
            Self::List(_) => "a list",
            Self::Map(_) => "a map",
            Self::Other(words) => words,
        }
    }
}

/// A bare name with its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Key<'a> {
    /// The name.
    pub(crate) name: &'a str,
    /// Its place.
    pub(crate) span: Span,
}

/// Sees what `ron` finds.
pub(super) struct Look<'a>(pub(super) Raw<'a>);

impl<'a> Look<'a> {
    fn key(&self, name: &'a str) -> Key<'a> {
        Key { name, span: self.0.span_of(name) }
    }

    /// The name in front of a bracket. `ron` drops it when it does not know beforehand what will come.
    fn called(&self) -> Option<Key<'a>> {
        let text = self.0.text();
        let end =
            text.find(|c: char| c == '(' || c == '/' || c.is_whitespace() || c.is_control()).unwrap_or(text.len());
        (end > 0).then(|| self.key(&text[..end]))
    }

    fn first(&self) -> char {
        self.0.text().chars().next().unwrap_or(' ')
    }

    fn number<E>(&self, value: f64) -> Result<Shape<'a>, E> {
        Ok(Shape::Number(Number::new(value, self.0)))
    }

    fn items<A: SeqAccess<'a>>(&self, mut access: A) -> Result<Vec<Raw<'a>>, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = access.next_element_seed(Capture(self.0))? {
            items.push(item);
        }
        Ok(items)
    }

    fn entries<A: MapAccess<'a>>(&self, mut access: A) -> Result<Shape<'a>, A::Error> {
        let mut entries = Vec::new();
        while let Some(key) = access.next_key_seed(Capture(self.0))? {
            entries.push((key, access.next_value_seed(Capture(self.0))?));
        }
        Ok(Shape::Map(entries))
    }

    fn fields<A: MapAccess<'a>>(&self, mut access: A) -> Result<Shape<'a>, A::Error> {
        let mut fields = Vec::new();
        while let Some(name) = access.next_key::<&'a str>()? {
            fields.push((self.key(name), access.next_value_seed(Capture(self.0))?));
        }
        Ok(Shape::Struct(self.called(), fields))
    }
}

impl<'de> Visitor<'de> for Look<'de> {
    type Value = Shape<'de>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a value")
    }

    fn visit_bool<E>(self, _: bool) -> Result<Self::Value, E> {
        Ok(Shape::Name(self.0.text()))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Self::Value, E> {
        self.number(value as f64)
    }

    fn visit_u64<E>(self, value: u64) -> Result<Self::Value, E> {
        self.number(value as f64)
    }

    fn visit_f64<E>(self, value: f64) -> Result<Self::Value, E> {
        self.number(value)
    }

    fn visit_char<E>(self, _: char) -> Result<Self::Value, E> {
        Ok(Shape::Other("a character"))
    }

    fn visit_borrowed_str<E>(self, text: &'de str) -> Result<Self::Value, E> {
        Ok(Shape::Text(Cow::Borrowed(text)))
    }

    fn visit_str<E>(self, text: &str) -> Result<Self::Value, E> {
        Ok(Shape::Text(Cow::Owned(text.to_owned())))
    }

    fn visit_bytes<E>(self, _: &[u8]) -> Result<Self::Value, E> {
        Ok(Shape::Other("a byte string"))
    }

    fn visit_none<E>(self) -> Result<Self::Value, E> {
        Ok(Shape::Name(self.0.text()))
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        IgnoredAny::deserialize(deserializer)?;
        Ok(Shape::Other("an option"))
    }

    fn visit_unit<E>(self) -> Result<Self::Value, E> {
        Ok(match self.first() {
            '(' => Shape::Struct(None, Vec::new()),
            '.' => Shape::Other("a range"),
            _ => Shape::Name(self.0.text()),
        })
    }

    fn visit_seq<A: SeqAccess<'de>>(self, access: A) -> Result<Self::Value, A::Error> {
        let items = self.items(access)?;
        Ok(match self.first() {
            '[' => Shape::List(items),
            _ if items.is_empty() => Shape::Struct(self.called(), Vec::new()),
            _ => Shape::Tuple(self.called(), items),
        })
    }

    fn visit_map<A: MapAccess<'de>>(self, access: A) -> Result<Self::Value, A::Error> {
        match self.first() {
            '{' => self.entries(access),
            '0'..='9' | '+' | '-' | '.' => Ok(Shape::Other("a range")),
            'i' | 'N' if !self.0.text().ends_with(')') => Ok(Shape::Other("a range")),
            _ => self.fields(access),
        }
    }
}
