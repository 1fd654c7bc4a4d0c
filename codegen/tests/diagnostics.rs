//! Every way to get a graph wrong, and what a person then reads.
//!
//! A case is a folder in `/tests/diagnostics`: files that change the valid project in `_base`, and the text that
//! checking them prints. `BLESS=1 cargo test -p terrane-codegen --test diagnostics` accepts what is printed now.

mod support;

use std::fs;

use support::{base, files, folder, golden, report};
use terrane_codegen::graph::codes;

#[test]
fn cases_print_what_was_accepted() {
    let failures: Vec<String> = cases().iter().filter_map(|case| run(case).err()).collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

fn cases() -> Vec<String> {
    let entries = fs::read_dir(folder()).expect("the test folder is there");
    let names = entries.map(|entry| entry.expect("a readable folder").file_name().into_string().expect("ASCII names"));
    // Cases without files of their own are made by `limits.rs`.
    let has_files = |name: &String| files(&folder().join(name)).keys().any(|path| path != "expected.txt");
    let mut cases: Vec<String> = names.filter(|name| !name.starts_with('_') && has_files(name)).collect();
    cases.sort();
    assert!(cases.len() > 50, "cases are missing");
    cases
}

fn run(case: &str) -> Result<(), String> {
    let mut project = base();
    let mut changed = files(&folder().join(case));
    changed.remove("expected.txt");
    let checked: Vec<String> = changed.keys().filter(|path| path.starts_with("graphs/")).cloned().collect();
    project.0.extend(changed);
    let found = report(project, &checked);
    if found.is_empty() {
        return Err(format!("{case}: nothing is found"));
    }
    golden(case, &found)
}

/// Codes that need a real disk, tested in `disk.rs`.
const ON_DISK: [&str; 2] = ["TG102", "TG160"];

#[test]
fn every_code_has_a_case() {
    if support::blessing() {
        return;
    }
    let texts: Vec<Vec<u8>> =
        files(&folder()).into_iter().filter(|(path, _)| path.ends_with("expected.txt")).map(|(_, text)| text).collect();
    let texts = texts.into_iter().map(|text| String::from_utf8(text).expect("UTF-8")).collect::<String>();
    let missing: Vec<&str> = codes::ALL
        .iter()
        .map(|(code, _)| code.id)
        .filter(|id| !ON_DISK.contains(id) && !texts.contains(&format!("[{id} ")))
        .collect();
    assert!(missing.is_empty(), "no case shows {missing:?}");
}
