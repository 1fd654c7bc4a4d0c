//! Equal graphs give equal bytes: in another process, with other threads and locale, and in another order.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::scratch::Scratch;

/// The WGSL and the manifest that `terrane build` writes for the alpine terrain.
fn build(scratch: &Scratch, variables: &[(&str, &str)]) -> BTreeMap<String, String> {
    let arguments = ["build", "graphs/terrains/alpine.ron", "-o", "out", "--no-textures"];
    scratch.terrane_with(variables, &arguments);
    let entries = fs::read_dir(scratch.path("out")).expect("terrane made it");
    let read = |path: &Path| fs::read_to_string(path).expect("text");
    let paths = entries.map(|entry| entry.expect("a readable folder").path());
    paths.map(|path| (path.file_name().expect("a file").to_string_lossy().into_owned(), read(&path))).collect()
}

#[test]
fn processes_threads_and_locale_make_no_difference() {
    let first = build(&Scratch::of("."), &[("RAYON_NUM_THREADS", "1"), ("LC_ALL", "C")]);
    assert_eq!(first.len(), 3);
    let second =
        build(&Scratch::of("."), &[("RAYON_NUM_THREADS", "2"), ("LC_ALL", "tr_TR.UTF-8"), ("TZ", "Asia/Tokyo")]);
    same(&first, &second);
}

#[test]
fn the_order_of_entries_in_a_map_makes_no_difference() {
    let straight = build(&Scratch::of("."), &[]);
    let shuffled = Scratch::of(".");
    let mut moved = 0;
    for folder in ["surfaces", "instances", "masks"] {
        for entry in fs::read_dir(shuffled.path(&format!("graphs/{folder}"))).expect("it was copied") {
            let path = entry.expect("a readable folder").path();
            let text = fs::read_to_string(&path).expect("a graph");
            let turned = turned(&text);
            moved += usize::from(turned != text);
            fs::write(path, turned).expect("a writable copy");
        }
    }
    assert!(moved > 20, "only {moved} files have maps to turn around");
    let without_lines = |files: BTreeMap<String, String>| -> BTreeMap<String, String> {
        // Where in its file a node stands is the one thing that must change.
        let kept =
            |text: &str| text.lines().filter(|line| !line.contains("\"file_line\"")).collect::<Vec<_>>().join("\n");
        files.iter().map(|(name, text)| (name.clone(), kept(text))).collect()
    };
    same(&without_lines(straight), &without_lines(build(&shuffled, &[])));
}

/// Fails with the first line that differs, not with all of both.
#[track_caller]
fn same(first: &BTreeMap<String, String>, second: &BTreeMap<String, String>) {
    assert!(first.keys().eq(second.keys()), "{:?} and {:?}", first.keys(), second.keys());
    for (name, text) in first {
        for (index, (a, b)) in text.lines().zip(second[name].lines()).enumerate() {
            assert_eq!(a, b, "{name}:{}", index + 1);
        }
        assert!(*text == second[name], "{name}: one is longer");
    }
}

/// The text with the entries of every map in reverse order; entries stand on lines of their own.
fn turned(text: &str) -> String {
    let is_entry = |line: &str| line.starts_with("        \"");
    let mut lines: Vec<&str> = text.lines().collect();
    for entries in lines.chunk_by_mut(|a, b| is_entry(a) && is_entry(b)) {
        entries.reverse();
    }
    lines.join("\n") + "\n"
}
