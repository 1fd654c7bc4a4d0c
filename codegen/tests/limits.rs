//! Input that costs too much, or that no repository keeps: a diagnostic, soon.

mod support;

use std::fmt::Write as _;

use support::{base, golden, report};
use terrane_codegen::graph::{Memory, limits};

const SURFACE: &str = "graphs/surfaces/bad.ron";

fn surface(body: &str) -> Memory {
    base().with(SURFACE, format!("Surface(\n    version: 1,\n{body})\n"))
}

fn check(case: &str, files: Memory, path: &str) {
    let found = report(files, &[path.to_owned()]);
    if let Err(difference) = golden(case, &found) {
        panic!("{difference}");
    }
}

fn instance(nodes: &str) -> String {
    format!("Instance(\n    version: 1,\n    nodes: {{ {nodes} }},\n    outputs: ( out: a ),\n)\n")
}

#[test]
fn a_file_of_four_mebibytes() {
    let comment = format!("    // {}\n    outputs: ( albedo: 0.5 ),\n", "x".repeat(limits::FILE_BYTES as usize));
    check("limit_file", surface(&comment), SURFACE);
}

#[test]
fn a_file_that_is_not_utf_8() {
    let text = b"Surface(version: 1, doc: \"\xff\xfe\")\n";
    check("unreadable_not_utf8", base().with(SURFACE, text.as_slice()), SURFACE);
}

#[test]
fn brackets_in_brackets() {
    let nested = format!("    doc: {}{},\n", "[".repeat(limits::DEPTH), "]".repeat(limits::DEPTH));
    check("limit_depth", surface(&nested), SURFACE);
}

#[test]
fn a_hundred_thousand_brackets_do_not_overflow_the_stack() {
    let body = format!("    doc: {}", "[({a:".repeat(100_000));
    let found = report(surface(&body), &[SURFACE.to_owned()]);
    assert!(found.contains("brackets are nested more than 128 deep"), "{}", &found[..found.len().min(2000)]);
    assert!(found.len() < 1000, "a line that nobody can read is not shown");
}

#[test]
fn many_nodes() {
    let nodes = (0..=limits::NODES).fold(String::new(), |mut text, index| {
        let _ = writeln!(text, "        \"n{index}\": contrast(x: slope),");
        text
    });
    check("limit_nodes", surface(&format!("    nodes: {{\n{nodes}    }},\n    outputs: ( albedo: 0.5 ),\n")), SURFACE);
}

#[test]
fn many_arguments() {
    let arguments = (0..=limits::EDGES).fold(String::new(), |mut text, index| {
        let _ = writeln!(text, "            a{index}: slope,");
        text
    });
    let body = format!(
        "    nodes: {{\n        \"a\": contrast(\n{arguments}        ),\n    }},\n    outputs: ( albedo: a ),\n"
    );
    check("limit_arguments", surface(&body), SURFACE);
}

#[test]
fn long_texts_and_names() {
    let (text, name) = ("x".repeat(limits::STRING_BYTES + 1), "x".repeat(65));
    let steps = ".x".repeat(20);
    let body = format!(
        "    doc: \"{text}\",\n    nodes: {{\n        \"{name}\": contrast(x: \"slope{steps}\"),\n    }},\n    outputs: ( albedo: {name} ),\n"
    );
    check("limit_texts", surface(&body), SURFACE);
}

#[test]
fn instances_in_instances() {
    let mut files = surface("    nodes: { \"a\": level0() },\n    outputs: ( albedo: a ),\n");
    for level in 0..=limits::INCLUDE_DEPTH {
        let call = format!("\"a\": level{}()", level + 1);
        files = files.with(&format!("graphs/instances/level{level}.ron"), instance(&call));
    }
    let last = format!("graphs/instances/level{}.ron", limits::INCLUDE_DEPTH + 1);
    check("limit_include_depth", files.with(&last, instance("\"a\": contrast(x: slope)")), SURFACE);
}

#[test]
fn many_files() {
    let mut nodes = String::new();
    let mut files = base();
    for index in 0..limits::FILES {
        let _ = writeln!(nodes, "        \"n{index}\": part{index}(),");
        files = files.with(&format!("graphs/instances/part{index}.ron"), instance("\"a\": contrast(x: slope)"));
    }
    let body = format!("Surface(\n    version: 1,\n    nodes: {{\n{nodes}    }},\n    outputs: ( albedo: n0 ),\n)\n");
    check("limit_files", files.with(SURFACE, body), SURFACE);
}

#[test]
fn instances_that_multiply() {
    let calls = |kind: &str| {
        (0..10)
            .map(|index| format!("\"{}\": {kind}(), ", ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"][index]))
            .collect::<String>()
    };
    let mut files = surface("    nodes: { \"a\": level0() },\n    outputs: ( albedo: a ),\n");
    for level in 0..12 {
        files =
            files.with(&format!("graphs/instances/level{level}.ron"), instance(&calls(&format!("level{}", level + 1))));
    }
    let files = files.with("graphs/instances/level12.ron", instance("\"a\": contrast(x: slope)"));
    let found = report(files, &[SURFACE.to_owned()]);
    assert!(found.contains("more than 10000 nodes, those of its instances counted"), "{found}");
    assert_eq!(found.matches("error[").count(), 1, "{found}");
}

#[test]
fn many_layers() {
    let layers = "(surface: \"graphs/surfaces/scree.ron\"),\n".repeat(limits::LAYERS + 1);
    let height = "(file: \"textures/alpine_height.png\", size: (4096.0, 4096.0), range: (0.0, 1200.0))";
    let text = format!("Terrain(\n    version: 1,\n    height: {height},\n    layers: [\n{layers}    ],\n)\n");
    check("limit_layers", base().with("graphs/terrains/bad.ron", text), "graphs/terrains/bad.ron");
}

#[test]
fn layers_that_add_up() {
    let nodes: String = (0..6000).map(|index| format!("\"n{index}\": contrast(x: slope),\n")).collect();
    let surface = format!("Surface(version: 1, nodes: {{ {nodes} }}, outputs: ( albedo: n0 ))");
    let height = "(file: \"textures/alpine_height.png\", size: (4096.0, 4096.0), range: (0.0, 1200.0))";
    let layer = "(surface: \"graphs/surfaces/bad.ron\"), ";
    let text = format!("Terrain(version: 1, height: {height}, layers: [{layer}{layer}])");
    let files = base().with(SURFACE, surface).with("graphs/terrains/bad.ron", text);
    let found = report(files, &["graphs/terrains/bad.ron".to_owned()]);
    assert!(found.contains("the layers have 12000 nodes, the limit is 10000"), "{}", &found[..found.len().min(2000)]);
}

#[test]
fn a_report_has_an_end() {
    let nodes: String = (0..1000).map(|index| format!("\"n{index}\": contrasd(x: slope),\n")).collect();
    let found = report(surface(&format!("nodes: {{ {nodes} }}, outputs: ( albedo: n0 ),")), &[SURFACE.to_owned()]);
    assert_eq!(found.matches("error[").count(), limits::FINDINGS);
    assert!(found.contains("800 more findings are not shown"), "{}", &found[found.len() - 500..]);
}

#[test]
fn the_largest_graph_is_quick() {
    // A chain: every node reads the one before it, so that order, depth and look-up are at their worst.
    let nodes: String =
        (1..limits::NODES).map(|index| format!("\"n{index}\": contrast(x: n{}, amount: 1.5),\n", index - 1)).collect();
    let body =
        format!("nodes: {{ \"n0\": contrast(x: slope), {nodes} }}, outputs: ( albedo: n{} ),", limits::NODES - 1);
    let begin = std::time::Instant::now();
    let found = report(surface(&body), &[SURFACE.to_owned()]);
    assert!(found.is_empty(), "{}", &found[..found.len().min(2000)]);
    // A debug build of a busy machine takes a second; what this guards against takes minutes.
    assert!(begin.elapsed().as_secs() < 20, "{:?}", begin.elapsed());
}
