//! The nodes on the graphics device: examples hold there too, and every result is one that WGSL's accuracy table allows.

mod device;
mod probe;

use terrane_codegen::library::{Kind, Overload};
use terrane_codegen::machine::domain::{Accept, Interval};
use terrane_codegen::machine::{Component, Value};

use self::device::Device;
use super::LIBRARY;
use super::call::machine;
use super::examples::ty;
use super::ranges::{POINTS, inputs, output_ranges, witness};
use super::watched::Watched;

/// Points that are compared: enough for the device, and few enough for the intervals.
const COMPARED: usize = 400;

/// Texels are known within bounds only, and among the normals of the example texture there are some without a direction:
/// other tests tie these nodes to their heights.
const KNOWN_BY_BOUNDS: [&str; 1] = ["triplanar_normal"];

#[test]
fn examples_hold_on_the_device() {
    let Ok(device) = Device::open().map_err(crate::skip::Skip::report) else { return };
    let wrong: Vec<String> = LIBRARY.kinds.values().flat_map(|kind| wrong_examples(&device, kind)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn wrong_examples(device: &Device, kind: &Kind) -> Vec<String> {
    let examples = &kind.examples;
    let calls: Vec<(&str, &str)> =
        examples.iter().map(|example| (ty(&example.expected), example.call.as_str())).collect();
    let expected: Vec<(&str, &str)> =
        examples.iter().map(|example| (ty(&example.expected), example.expected.as_str())).collect();
    let found = device.run(&probe::expressions(&calls), &[], examples.len() * 4);
    let expected = device.run(&probe::expressions(&expected), &[], examples.len() * 4);
    let pairs = examples.iter().zip(found.chunks(4).zip(expected.chunks(4)));
    // Twice the tolerance: it is stated for correctly rounded arithmetic.
    let far = |tolerance: f64| move |(a, b): (&f32, &f32)| f64::from((a - b).abs()) > 2.0 * tolerance;
    pairs
        .filter(|(example, (found, expected))| found.iter().zip(*expected).any(far(example.tolerance)))
        .map(|(example, (found, expected))| format!("{} is {found:?}, not {expected:?}", example.call))
        .collect()
}

#[test]
fn results_are_acceptable() {
    let Ok(device) = Device::open().map_err(crate::skip::Skip::report) else { return };
    let overloads = LIBRARY.kinds.values().flat_map(|kind| &kind.overloads);
    let wrong: Vec<String> = overloads.flat_map(|overload| unacceptable(&device, overload)).collect();
    assert!(wrong.is_empty(), "{} findings:\n{}", wrong.len(), wrong.join("\n"));
}

/// Results outside the declared range, or outside what a conforming implementation may return.
fn unacceptable(device: &Device, overload: &Overload) -> Vec<String> {
    let values = inputs(overload);
    let ranges = output_ranges(overload);
    if ranges.is_empty() {
        return Vec::new();
    }
    let words = probe::words(&values, POINTS);
    let results = device.run(&probe::calls(overload), &words, POINTS * ranges.len());
    let results: Vec<&[f32]> = results.chunks(ranges.len()).collect();
    let in_range = |components: &[f32]| {
        components.iter().zip(&ranges).all(|(number, range)| {
            number.is_finite() && range.is_none_or(|(low, high)| *number >= low && *number <= high)
        })
    };
    let outside = (0..POINTS).filter(|point| !in_range(results[*point])).take(2);
    let outside = outside.map(|point| witness(overload, &values, point, results[point]));
    let accepted = accepted(overload, &values);
    let vacuous = (vacuity(&accepted) > 0.6 && !KNOWN_BY_BOUNDS.contains(&overload.function.as_str())).then(|| {
        format!("{}: anything is accepted at {:.0} % of the points", overload.function, 100.0 * vacuity(&accepted))
    });
    let refused = (0..COMPARED).filter(|point| {
        let intervals = accepted.iter().map(|component| component[*point]);
        !results[point_of(*point)].iter().zip(intervals).all(|(number, interval)| interval.accepts(*number))
    });
    let refused = refused.take(2).map(|point| {
        let intervals: Vec<Interval> = accepted.iter().map(|component| component[point]).collect();
        let at = point_of(point);
        format!("{}, accepted {intervals:?}", witness(overload, &values, at, results[at]))
    });
    outside.chain(vacuous).chain(refused).collect()
}

/// The share of results of which nothing is known.
fn vacuity(accepted: &[Vec<Interval>]) -> f64 {
    let unknown = accepted.iter().flatten().filter(|interval| interval.is_unbounded()).count();
    unknown as f64 / (accepted.len() * COMPARED).max(1) as f64
}

/// The compared points are the random ones, which come last, with some of the corners.
fn point_of(index: usize) -> usize {
    if index < COMPARED / 4 { index * 16 } else { POINTS - COMPARED + index }
}

/// For each float of the result, what may come out at the compared points.
fn accepted(overload: &Overload, values: &[Vec<Value<Watched>>]) -> Vec<Vec<Interval>> {
    let arguments: Vec<Value<Accept>> = values.iter().flatten().map(as_intervals).collect();
    let called = machine().call::<Accept>(&overload.function, &arguments, COMPARED);
    let (value, _) = called.unwrap_or_else(|error| panic!("{}: {error}", overload.function));
    let spread = |intervals: Vec<Interval>| (0..COMPARED).map(|at| intervals[at % intervals.len()]).collect();
    let floats = value.components.into_iter().filter_map(|component| match component {
        Component::Float(intervals) => Some(spread(intervals)),
        _ => None,
    });
    floats.collect()
}

fn as_intervals(value: &Value<Watched>) -> Value<Accept> {
    let pick = |length: usize| (0..COMPARED).map(move |index| point_of(index) % length);
    Value::join(value.components.iter().map(|component| match component {
        Component::Float(numbers) => Value::f32(&pick(numbers.len()).map(|at| numbers[at]).collect::<Vec<_>>()),
        Component::Int(bits) => Value::u32(&pick(bits.len()).map(|at| bits[at]).collect::<Vec<_>>()),
        Component::Truth(truths) => Value::bool(&pick(truths.len()).map(|at| truths[at]).collect::<Vec<_>>()),
        Component::Handle(id) => Value::handle(*id),
    }))
}
