//! `terrane nodes`: what a graph may use.

use std::fmt::Write as _;

use terrane_codegen::diagnostic::{Sources, render};
use terrane_codegen::library::{Cost, Kind, Library, Overload, Port, costs};

use super::Failure;

/// List the nodes that a graph may use, or read about one
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  terrane nodes\n  terrane nodes overlay")]
pub(crate) struct Nodes {
    /// The node to read about; all of them are listed if there is none
    name: Option<String>,
}

impl Nodes {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let mut sources = Sources::default();
        let library = Library::load(&mut sources, &[])
            .map_err(|findings| Failure::Findings(render(&findings, &sources, false)))?;
        let text = match &self.name {
            None => list(&library),
            Some(name) => match library.kinds.get(name) {
                Some(kind) => page(kind, &costs(&library.module)),
                None => return Err(unknown(name, &library)),
            },
        };
        print!("{text}");
        Ok(())
    }
}

fn unknown(name: &str, library: &Library) -> Failure {
    let near = terrane_codegen::graph::nearest(name, library.kinds.keys().map(String::as_str));
    let hint = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
    Failure::Usage(format!("there is no node `{name}`{hint} `terrane nodes` lists all"))
}

fn list(library: &Library) -> String {
    let mut text = String::new();
    let mut categories: Vec<&str> = library.kinds.values().map(|kind| kind.category.as_str()).collect();
    categories.sort_unstable();
    categories.dedup();
    for category in categories {
        let _ = writeln!(text, "{category}");
        for kind in library.kinds.values().filter(|kind| kind.category == category) {
            let _ = writeln!(text, "  {:<22} {}", kind.name, kind.summary);
        }
        text.push('\n');
    }
    let _ = writeln!(text, "{} nodes. `terrane nodes NAME` tells more about one.", library.kinds.len());
    text
}

fn page(kind: &Kind, costs: &std::collections::BTreeMap<String, Cost>) -> String {
    let mut text = format!("{} ({})\n\n{}\n", kind.name, kind.category, kind.doc);
    for overload in &kind.overloads {
        let _ = write!(text, "\n{}", signature(kind, overload));
        let cost = costs.get(&overload.function).copied().unwrap_or_default();
        let _ = writeln!(text, "  cost    {}", cost_text(cost));
    }
    text.push_str("\nexamples\n");
    for example in &kind.examples {
        let _ = writeln!(text, "  {} == {} +- {:e}", example.call, example.expected, example.tolerance);
    }
    let _ = writeln!(text, "\nsource\n  {}", kind.source);
    text
}

fn signature(kind: &Kind, overload: &Overload) -> String {
    let names: Vec<String> = overload.inputs.iter().map(|port| format!("{}: …", port.name)).collect();
    let mut text = format!("{}({}) -> {}\n", kind.name, names.join(", "), overload.output.ty);
    let inputs = overload.inputs.iter().map(|port| ("in", port));
    let outputs = std::iter::once(("out", &overload.output)).filter(|_| overload.members.is_empty());
    let members = overload.members.iter().map(|port| ("out", port));
    for (direction, port) in inputs.chain(outputs).chain(members) {
        let _ = writeln!(
            text,
            "  {direction:<4} {:<12} {:<8} {:<22} {}",
            port.name,
            port.ty.to_string(),
            facts(port),
            port.doc
        );
    }
    text
}

/// `[m] const 1.0..8.0 = 2.0`
fn facts(port: &Port) -> String {
    let unit = port.unit.as_ref().map(|unit| format!("[{unit}]"));
    let constant = port.constant.then(|| "const".to_owned());
    let range = port.range.map(|(low, high)| format!("{low}..{high}"));
    let default = port.default.map(|default| format!("= {}", plain(&default.wgsl())));
    let facts: Vec<String> = [unit, constant, range, default].into_iter().flatten().collect();
    facts.join(" ")
}

/// A literal as a graph writes it: `(0.0, 0.0, 1.0)` for `vec3f(0.0f, 0.0f, 1.0f)`.
fn plain(wgsl: &str) -> String {
    let numbers = wgsl.find('(').map_or(wgsl, |open| &wgsl[open..]);
    numbers.replace(['f', 'u', 'i'], "")
}

fn cost_text(cost: Cost) -> String {
    let parts = [
        (cost.samples, "texture samples"),
        (cost.loads, "texture loads"),
        (cost.arithmetic, "cheap operations"),
        (cost.slow, "slow operations"),
        (cost.branches, "branches"),
        (cost.loops, "loops"),
    ];
    let shown: Vec<String> =
        parts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    if shown.is_empty() { "none".into() } else { shown.join(", ") }
}
