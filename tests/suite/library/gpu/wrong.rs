//! The judge has teeth: nodes that are wrong in one number are rejected.

use std::ops::Range;

use terrane_codegen::library::Overload;
use terrane_codegen::machine::Probe;
use terrane_codegen::machine::probe::arguments;

use super::super::LIBRARY;
use super::device::Device;
use super::judged::judge;

const POINTS: usize = 300;

/// How many times too large a number is.
const FACTOR: f64 = 1.001;

/// The percentage that must be rejected. The others guard a division that these points do not need, or say where two
/// branches meet that agree there.
const REJECTED: usize = 65;

#[test]
fn nodes_with_a_wrong_number_are_rejected() {
    let Ok(device) = Device::open().map_err(crate::skip::Skip::report) else { return };
    let overloads = LIBRARY.kinds.values().flat_map(|kind| &kind.overloads);
    let judged: Vec<(String, bool)> = overloads.flat_map(|overload| judged(&device, overload)).collect();
    let accepted = judged.iter().filter(|(_, rejected)| !rejected).map(|(what, _)| what.as_str());
    let accepted: Vec<&str> = accepted.collect();
    let rejected = judged.len() - accepted.len();
    println!("{rejected} of {} wrong nodes are rejected, but not\n{}", judged.len(), accepted.join("\n"));
    assert!(rejected * 100 > judged.len() * REJECTED, "only {rejected} of {} wrong nodes are rejected", judged.len());
}

/// The node with each of its numbers wrong in turn, and whether that was noticed.
fn judged(device: &Device, overload: &Overload) -> Vec<(String, bool)> {
    let probe = Probe::new(&LIBRARY, &overload.function).unwrap_or_else(|error| panic!("{error}"));
    let arguments = arguments(overload, POINTS, 1).unwrap_or_else(|error| panic!("{error}"));
    let words = probe.words(&arguments, POINTS);
    let text = LIBRARY.slice(LIBRARY.names[&overload.function]);
    let one = |(at, number): (Range<usize>, f64)| {
        let wrong = format!("{}{:?}{}", &text[..at.start], number * FACTOR, &text[at.end..]);
        let broken = Probe { shader: probe.shader.replacen(text, &wrong, 1), ..probe.clone() };
        let verdict = judge(&probe, &arguments, POINTS, &device.run(&broken, &words, POINTS));
        let line = text[..at.start].rfind('\n').map_or(0, |end| end + 1);
        let line = text[line..].lines().next().unwrap_or_default().trim();
        (format!("{}: {number} in {line}", overload.function), !verdict.rejected.is_empty())
    };
    numbers(text).into_iter().map(one).collect()
}

/// The numbers with a point in a function's body, but for 0.
fn numbers(function: &str) -> Vec<(Range<usize>, f64)> {
    let is_body = |line: &&str| line.starts_with("    ") && !line.trim().starts_with("//");
    let signature = function.find(") -> ").unwrap_or(function.len());
    let lines = function[signature..].lines().filter(is_body);
    // Slices of one text: the difference of their places is the place in it.
    let words =
        lines.flat_map(|line| line.split(|letter: char| !letter.is_ascii_alphanumeric() && !"._".contains(letter)));
    let number = |word: &str| {
        let at = word.as_ptr() as usize - function.as_ptr() as usize;
        let number: f64 = word.contains('.').then(|| word.parse().ok()).flatten()?;
        (number != 0.0).then_some((at..at + word.len(), number))
    };
    words.filter_map(number).collect()
}
