//! What every node must say of itself, beyond what the loader already insists on.

use std::collections::BTreeSet;

use naga::{Expression, SampleLevel, Statement};
use terrane_codegen::library::{Kind, Overload, Port};
use terrane_codegen::value::Type;

use super::LIBRARY;

const CATEGORIES: [&str; 10] =
    ["frame", "hash", "noise", "shape", "mask", "sample", "blend", "heightfield", "shade", "math"];

fn ports(overload: &Overload) -> impl Iterator<Item = &Port> {
    let result = (!matches!(overload.output.ty, Type::Struct(_))).then_some(&overload.output);
    overload.inputs.iter().chain(result)
}

fn failures(check: impl Fn(&Kind, &Overload) -> Vec<String>) {
    let kinds = LIBRARY.kinds.values();
    let found: Vec<String> =
        kinds.flat_map(|kind| kind.overloads.iter().flat_map(|overload| check(kind, overload))).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn there_are_at_least_seventy_kinds() {
    assert!(LIBRARY.kinds.len() >= 70, "{}", LIBRARY.kinds.len());
}

#[test]
fn kinds_stand_in_a_category_and_end_their_summary() {
    for kind in LIBRARY.kinds.values() {
        assert!(CATEGORIES.contains(&kind.category.as_str()), "{}: category {}", kind.name, kind.category);
        assert!(kind.summary.len() > 15 && kind.summary.len() < 160, "{}: {}", kind.name, kind.summary);
        assert!(kind.source.len() > 6 && kind.source.ends_with('.'), "{}: {}", kind.name, kind.source);
    }
}

#[test]
fn every_number_has_a_range() {
    failures(|_, overload| {
        let bare = ports(overload).filter(|port| {
            let number = port.ty.components().is_some();
            number && port.range.is_none() && port.ty != Type::U32
        });
        bare.map(|port| format!("{}: port `{}` has no range", overload.function, port.name)).collect()
    });
}

#[test]
fn every_port_is_described_once() {
    failures(|_, overload| {
        let mut seen = BTreeSet::new();
        let twice = ports(overload).filter(|port| !port.name.is_empty() && !seen.insert(port.doc.clone()));
        twice.map(|port| format!("{}: `{}` repeats a description", overload.function, port.name)).collect()
    });
}

#[test]
fn ranges_of_vectors_are_the_same_in_all_overloads() {
    for kind in LIBRARY.kinds.values() {
        for overload in &kind.overloads[1..] {
            for (first, other) in kind.overloads[0].inputs.iter().zip(&overload.inputs) {
                assert_eq!((&first.name, &first.unit), (&other.name, &other.unit), "{}", overload.function);
            }
        }
    }
}

#[test]
fn every_node_may_stand_inside_a_branch() {
    for (_, function) in LIBRARY.module.functions.iter() {
        for (_, expression) in function.expressions.iter() {
            let implicit = match expression {
                Expression::Derivative { .. } => true,
                Expression::ImageSample { level, .. } => matches!(level, SampleLevel::Auto | SampleLevel::Bias(_)),
                _ => false,
            };
            assert!(!implicit, "{:?} needs uniform control flow: {expression:?}", function.name);
        }
        let kills = function.body.iter().any(|statement| matches!(statement, Statement::Kill));
        assert!(!kills, "{:?} discards", function.name);
    }
}

#[test]
fn the_library_has_no_globals() {
    assert!(LIBRARY.module.global_variables.is_empty() && LIBRARY.module.overrides.is_empty());
    assert!(LIBRARY.module.entry_points.is_empty());
}
