//! Results on the device are inside the declared range, and ones that a conforming implementation may give.
//!
//! Each node runs twice: at points as scenes have them, where nearly every result has bounds, and at the ends of its
//! ranges, where few operations are promised anything.

use terrane_codegen::library::Overload;
use terrane_codegen::machine::probe::{Verdict, arguments};
use terrane_codegen::machine::{F32, Probe, Value};
use terrane_codegen::value::Type;

use super::super::LIBRARY;
use super::super::call::machine;
use super::super::ranges;
use super::device::Device;

/// Points as scenes have them.
pub(super) const TYPICAL: usize = 1000;

/// The percentage of results that must have bounds, or little would be tested; and of the results of each node.
const BOUNDED: usize = 99;
const BOUNDED_OF_NODE: usize = 60;

/// The part of the end of a range by which rounding may go beyond it: WGSL promises no vector a length of 1 to the last bit, and an
/// NVIDIA driver gives components of 1.0000001.
const LAST_BITS: f32 = 2.4e-7;

/// What became of all results of a kind of points.
#[derive(Default)]
struct Tally {
    nodes: usize,
    words: usize,
    bounded: usize,
    wrong: Vec<String>,
}

impl Tally {
    fn add(&mut self, overload: &Overload, verdict: &Verdict, findings: Vec<String>) {
        let bounded = verdict.words - verdict.unbounded;
        self.nodes += 1;
        self.words += verdict.words;
        self.bounded += bounded;
        self.wrong.extend(findings);
        if bounded * 100 < verdict.words * BOUNDED_OF_NODE {
            let words = verdict.words;
            self.wrong.push(format!("{}: only {bounded} of {words} results have bounds", overload.function));
        }
    }
}

#[test]
fn results_are_acceptable() {
    let Ok(device) = Device::open().map_err(crate::skip::Skip::report) else { return };
    let typical =
        tally(&device, TYPICAL, |overload| arguments(overload, TYPICAL, 1).unwrap_or_else(|error| panic!("{error}")));
    let extreme = tally(&device, ranges::POINTS, ranges::inputs);
    for (tally, points) in [(&typical, "typical"), (&extreme, "extreme")] {
        println!(
            "{}, {points} points: {} nodes, {} results, {} with bounds, {} findings",
            device.name,
            tally.nodes,
            tally.words,
            tally.bounded,
            tally.wrong.len()
        );
    }
    let wrong = [typical.wrong.as_slice(), &extreme.wrong].concat();
    assert!(wrong.is_empty(), "{} findings:\n{}", wrong.len(), wrong.join("\n"));
    for tally in [typical, extreme] {
        assert!(tally.bounded * 100 > tally.words * BOUNDED, "too few of {} results have bounds", tally.words);
    }
}

fn tally(device: &Device, points: usize, arguments: impl Fn(&Overload) -> Vec<Value<F32>>) -> Tally {
    let mut tally = Tally::default();
    for overload in LIBRARY.kinds.values().flat_map(|kind| &kind.overloads) {
        let probe = Probe::new(&LIBRARY, &overload.function).unwrap_or_else(|error| panic!("{error}"));
        let arguments = arguments(overload);
        let results = device.run(&probe, &probe.words(&arguments, points), points);
        let verdict = judge(&probe, &arguments, points, &results);
        let findings = findings(overload, &arguments, &results, &verdict);
        tally.add(overload, &verdict, findings);
    }
    tally
}

/// What the machine says of results.
pub(super) fn judge(probe: &Probe, arguments: &[Value<F32>], points: usize, results: &[u32]) -> Verdict {
    let verdict = probe.judge(&machine(), arguments, points, results);
    verdict.unwrap_or_else(|error| panic!("{}: {error}", probe.function))
}

/// The first results outside the declared range, and the first that no conforming implementation may give.
fn findings(overload: &Overload, arguments: &[Value<F32>], results: &[u32], verdict: &Verdict) -> Vec<String> {
    let points = points(overload, results);
    let ranges = ranges::output_ranges(overload);
    let fits = |(number, range): (&f32, &Option<(f32, f32)>)| {
        let within = |(low, high): (f32, f32)| {
            let last = LAST_BITS * low.abs().max(high.abs());
            *number >= low - last && *number <= high + last
        };
        number.is_finite() && range.is_none_or(within)
    };
    let witness = |point: usize| {
        let components = points.get(point).map_or(&[][..], Vec::as_slice);
        ranges::witness(overload, arguments, point, components)
    };
    let outside = (0..points.len()).filter(|point| !points[*point].iter().zip(&ranges).all(fits));
    let rejected = verdict.rejected.iter().take(2);
    let rejected =
        rejected.map(|wrong| format!("{}; {wrong} ({} in all)", witness(wrong.point), verdict.rejected.len()));
    outside.take(2).map(witness).chain(rejected).collect()
}

/// The floats of the results. None for a `Place`, which has members that no port shows, and no ranges.
fn points(overload: &Overload, results: &[u32]) -> Vec<Vec<f32>> {
    let ports = match &overload.output.ty {
        Type::Struct(name) if name == "Place" => return Vec::new(),
        Type::Struct(_) => overload.members.iter().collect(),
        _ => vec![&overload.output],
    };
    let scalars: Vec<&Type> =
        ports.into_iter().flat_map(|port| vec![&port.ty; port.ty.components().unwrap_or(0)]).collect();
    let number = |(word, ty): (&u32, &&Type)| match ty {
        Type::I32 => *word as i32 as f32,
        Type::U32 => *word as f32,
        _ => f32::from_bits(*word),
    };
    results.chunks(scalars.len()).map(|words| words.iter().zip(&scalars).map(number).collect()).collect()
}
