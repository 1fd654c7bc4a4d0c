//! Examples: lines of documentation that a test evaluates.

use super::Reader;
use crate::library::codes;
use crate::library::item::Item;
use crate::library::kind::Example;

impl Reader<'_> {
    pub(super) fn examples(&mut self, item: &Item) -> Vec<Example> {
        let lines = item.doc.iter().filter(|(line, _)| is_example(line));
        let parsed: Vec<_> = lines.map(|(line, range)| (example(line), range.clone())).collect();
        let mut found = Vec::new();
        for (parts, range) in parsed {
            match parts {
                Some((call, expected, tolerance)) => {
                    found.push(Example { call, expected, tolerance, span: self.library.span(range) })
                }
                None => self.error(
                    codes::NODE_UNDOCUMENTED,
                    range,
                    "this example cannot be read",
                    "write `call == value +- tolerance`",
                ),
            }
        }
        found
    }
}

pub(super) fn is_example(line: &str) -> bool {
    line.contains("==") && line.contains("+-")
}

fn example(line: &str) -> Option<(String, String, f64)> {
    let (call, rest) = line.split_once("==")?;
    let (expected, tolerance) = rest.rsplit_once("+-")?;
    Some((call.trim().into(), expected.trim().into(), tolerance.trim().parse().ok()?))
}
