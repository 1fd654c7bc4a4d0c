//! Damaged and rearranged files: never a panic, never a place outside its text, never another meaning.

mod support;

use std::sync::{Arc, Mutex};

use proptest::prelude::*;
use proptest::sample::{Index, select, subsequence};
use support::{base, files, folder, without_spans};
use terrane_codegen::diagnostic::{Sources, render};
use terrane_codegen::graph::{FileError, Files, Memory, Project};

/// The valid project, and one text at every path that begins with `graphs/changed`.
#[derive(Clone)]
struct Changing {
    base: Memory,
    text: Arc<Mutex<Vec<u8>>>,
}

impl Files for Changing {
    fn read(&self, path: &str, limit: u64) -> Result<Vec<u8>, FileError> {
        if path.starts_with("graphs/changed") {
            Ok(self.text.lock().expect("no test panics in here").clone())
        } else {
            self.base.read(path, limit)
        }
    }

    fn head(&self, path: &str, length: usize) -> Result<Vec<u8>, FileError> {
        self.base.head(path, length)
    }

    fn list(&self, folder: &str) -> Vec<String> {
        self.base.list(folder)
    }
}

fn changing() -> (Project, Arc<Mutex<Vec<u8>>>) {
    let text = Arc::new(Mutex::new(Vec::new()));
    let files = Changing { base: base(), text: text.clone() };
    let mut sources = Sources::default();
    let library = support::library(&mut sources);
    let project =
        Project::with("".into(), Box::new(files), library, sources).unwrap_or_else(|error| panic!("{error:?}"));
    (project, text)
}

/// What can happen to a file.
#[derive(Clone, Debug)]
enum Damage {
    Delete(Index, usize),
    Duplicate(Index, usize, Index),
    Swap(Index, Index),
    Replace(Index, u8),
    Insert(Index, &'static str),
}

const PIECES: [&str; 24] = [
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "//",
    "/*",
    "*/",
    "-",
    "NaN",
    "1e999",
    "Some(1)",
    "..",
    "r#\"",
    "\\u{0}",
    "\u{200e}",
    "é",
    "#![enable(implicit_some)]",
    "'",
    "0x",
];

fn damage() -> impl Strategy<Value = Damage> {
    prop_oneof![
        (any::<Index>(), 1..40_usize).prop_map(|(at, length)| Damage::Delete(at, length)),
        (any::<Index>(), 1..40_usize, any::<Index>()).prop_map(|(at, length, to)| Damage::Duplicate(at, length, to)),
        (any::<Index>(), any::<Index>()).prop_map(|(a, b)| Damage::Swap(a, b)),
        (any::<Index>(), any::<u8>()).prop_map(|(at, byte)| Damage::Replace(at, byte)),
        (any::<Index>(), select(&PIECES[..])).prop_map(|(at, piece)| Damage::Insert(at, piece)),
    ]
}

fn apply(bytes: &mut Vec<u8>, damage: &Damage) {
    if bytes.is_empty() {
        return;
    }
    let size = bytes.len();
    let range = |at: &Index, length: usize| at.index(size)..(at.index(size) + length).min(size);
    match damage {
        Damage::Delete(at, length) => {
            bytes.drain(range(at, *length));
        }
        Damage::Duplicate(at, length, to) => {
            let piece = bytes[range(at, *length)].to_vec();
            let to = to.index(size);
            bytes.splice(to..to, piece);
        }
        Damage::Swap(a, b) => bytes.swap(a.index(size), b.index(size)),
        Damage::Replace(at, byte) => bytes[at.index(size)] = *byte,
        Damage::Insert(at, piece) => {
            let at = at.index(size);
            bytes.splice(at..at, piece.bytes());
        }
    }
}

#[test]
fn damaged_files_are_refused_politely() {
    let texts = files(&folder().join("_base")).into_iter().filter(|(path, _)| path.ends_with(".ron"));
    let originals: Vec<Vec<u8>> = texts.map(|(_, text)| text).collect();
    let (project, text) = changing();
    let state = std::cell::RefCell::new((project, 0));
    proptest!(ProptestConfig::with_cases(cases(3000)), |(original in select(originals), damages in prop::collection::vec(damage(), 1..6))| {
        let mut bytes = original.clone();
        damages.iter().for_each(|damage| apply(&mut bytes, damage));
        *text.lock().expect("no test panics in here") = bytes;
        let (project, count) = &mut *state.borrow_mut();
        *count += 1;
        let findings = project.check(&format!("graphs/changed{count}.ron"));
        for label in findings.iter().flat_map(|finding| &finding.labels) {
            let source = project.sources.get(label.span.source);
            prop_assert!(source.text.get(label.span.range()).is_some(), "{:?} in {}", label, source.path);
        }
        // Rendering reads every source again: a sample is enough.
        if *count % 100 == 0 {
            render(&findings, &project.sources, false);
        }
    });
}

fn cases(default: u32) -> u32 {
    std::env::var("PROPTEST_CASES").ok().and_then(|count| count.parse().ok()).unwrap_or(default)
}

const PARAMETERS: [&str; 3] = [
    r#""tint": (kind: color, default: (0.52, 0.50, 0.47))"#,
    r#""tile": (unit: "m", range: (0.5, 32.0), default: 4.0)"#,
    r#""steep": (range: (0.0, 1.0), default: 0.42)"#,
];
const TEXTURES: [&str; 2] = [
    r#""granite": (file: "textures/granite_albedo.png", color: srgb)"#,
    r#""cracks": (file: "textures/granite_height.png", color: linear, channel: r)"#,
];
const NODES: [&str; 6] = [
    r#""uv": planar(tile: tile, position: position)"#,
    r#""stone": texture(uv: uv, of: granite)"#,
    r#""crack": texture(of: cracks, uv: uv)"#,
    r#""ledge": ramp(high: 0.6, x: slope, low: steep)"#,
    r#""edge": broken_edge(sharpness: 2.0, base: ledge, detail: crack)"#,
    r#""color": mul(b: tint, a: "stone.rgb")"#,
];
const OUTPUTS: [&str; 4] =
    ["mask: edge", "albedo: color", "roughness: 0.85", "relief: (uv: uv, height: cracks, depth: 0.35)"];

fn shuffled(pieces: &'static [&'static str]) -> impl Strategy<Value = String> {
    subsequence(pieces, pieces.len()).prop_shuffle().prop_map(|pieces| pieces.join(", "))
}

fn arrangement() -> impl Strategy<Value = String> {
    let parts = (shuffled(&PARAMETERS), shuffled(&TEXTURES), shuffled(&NODES), shuffled(&OUTPUTS));
    parts.prop_flat_map(|(parameters, textures, nodes, outputs)| {
        let fields = vec![
            "version: 1".to_owned(),
            format!("parameters: {{ {parameters} }}"),
            format!("textures: {{ {textures} }}"),
            format!("nodes: {{ {nodes} }}"),
            format!("outputs: ( {outputs} )"),
        ];
        Just(fields).prop_shuffle().prop_map(|fields| format!("Surface( {} )", fields.join(", ")))
    })
}

#[test]
fn the_order_in_a_file_does_not_matter() {
    let (project, text) = changing();
    let state = std::cell::RefCell::new((project, None::<String>));
    proptest!(ProptestConfig::with_cases(cases(200)), |(arranged in arrangement())| {
        *text.lock().expect("no test panics in here") = arranged.into_bytes();
        let (project, first) = &mut *state.borrow_mut();
        // The same path each time: only its text may differ.
        let files = Changing { base: base(), text: text.clone() };
        let mut sources = Sources::default();
        let library = support::library(&mut sources);
        *project = Project::with("".into(), Box::new(files), library, sources).unwrap_or_else(|error| panic!("{error:?}"));
        let answer = project.surface("graphs/changed.ron");
        let (graphs, id, warnings) = answer.unwrap_or_else(|findings| panic!("{}", render(&findings, &project.sources, false)));
        prop_assert!(support::beside_relief(warnings).is_empty());
        let meaning = without_spans(&(graphs, id));
        prop_assert_eq!(first.get_or_insert_with(|| meaning.clone()), &meaning);
    });
}
