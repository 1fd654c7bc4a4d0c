//! The grammar of a port's documentation line:
//!
//! ```text
//! port  := sentence "." [ "[" unit "]" ] [ "const" ] [ number ".." number ] [ "=" default ]
//! default := number | "(" number { "," number } ")"
//! ```

use crate::value::{Literal, Type};

/// What a port line says.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct PortLine {
    pub(crate) doc: String,
    pub(crate) unit: Option<String>,
    pub(crate) constant: bool,
    pub(crate) range: Option<(f32, f32)>,
    pub(crate) default: Option<Vec<f64>>,
}

/// Reads a port line; the error says what is missing.
pub(crate) fn parse(line: &str) -> Result<PortLine, &'static str> {
    if line.is_empty() {
        return Err("there is no `///` line above it");
    }
    // A sentence may hold full stops of its own: it ends at the first one behind which everything is grammar.
    let stops = line.match_indices('.').map(|(at, _)| at + 1);
    let ends = stops.filter(|end| line[*end..].chars().next().is_none_or(char::is_whitespace));
    let found = ends
        .filter_map(|end| facts(&line[end..]).map(|facts| PortLine { doc: line[..end].to_owned(), ..facts }))
        .next();
    found.ok_or("expected `Sentence. [unit] const low..high = default`, where all behind the sentence is optional")
}

fn facts(tail: &str) -> Option<PortLine> {
    let mut facts = PortLine::default();
    let mut rest = tail.trim();
    if let Some(unit) = rest.strip_prefix('[') {
        let (unit, behind) = unit.split_once(']')?;
        facts.unit = (unit != "1").then(|| unit.to_owned());
        rest = behind.trim_start();
    }
    if let Some(behind) = rest.strip_prefix("const") {
        facts.constant = true;
        rest = behind.trim_start();
    }
    if let Some((before, default)) = rest.split_once('=') {
        facts.default = Some(numbers(default.trim())?);
        rest = before;
    }
    let range = rest.trim();
    if !range.is_empty() {
        let (low, high) = range.split_once("..")?;
        facts.range = Some((number(low)? as f32, number(high)? as f32)).filter(|(low, high)| low <= high);
        facts.range?;
    }
    Some(facts)
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    match text.strip_prefix('(').and_then(|text| text.strip_suffix(')')) {
        Some(list) => list.split(',').map(number).collect(),
        None => Some(vec![number(text)?]),
    }
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

/// The default as a literal of the port's type; one number fills a vector.
pub(crate) fn literal(values: &[f64], ty: &Type) -> Option<Literal> {
    match (ty, values) {
        (Type::I32, [value]) if value.fract() == 0.0 => Some(Literal::I32(*value as i32)),
        (Type::U32, [value]) if value.fract() == 0.0 && *value >= 0.0 => Some(Literal::U32(*value as u32)),
        (Type::I32 | Type::U32, _) => None,
        (_, [value]) => Some(Literal::floats(&vec![*value as f32; ty.components()?])),
        _ if ty.components() == Some(values.len()) => {
            Some(Literal::floats(&values.iter().map(|value| *value as f32).collect::<Vec<_>>()))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_line() {
        let line = parse("Wavelength of the first octave. [m] const 1..4096 = 64").expect("grammatical");
        assert_eq!((line.unit.as_deref(), line.constant, line.range), (Some("m"), true, Some((1.0, 4096.0))));
        assert_eq!(line.default, Some(vec![64.0]));
    }

    #[test]
    fn sentences_may_hold_stops() {
        let line = parse("Between 0.5 and 1.5. Not more. -0.5..1.5").expect("grammatical");
        assert_eq!((line.doc.as_str(), line.range), ("Between 0.5 and 1.5. Not more.", Some((-0.5, 1.5))));
    }

    #[test]
    fn vectors_and_mistakes() {
        let line = parse("Axis. = (0.0, 0.0, 1.0)").expect("grammatical");
        assert_eq!(literal(&line.default.expect("given"), &Type::Vec3), Some(Literal::floats(&[0.0, 0.0, 1.0])));
        for wrong in ["", "no stop", "Sentence. 1..0", "Sentence. 0..1 1.0", "Sentence. [m", "Sentence. = x"] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }
}
