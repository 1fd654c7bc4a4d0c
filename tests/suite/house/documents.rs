//! The documents speak of what exists.

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

use super::files::{File, root, with_endings};

/// Commands of Cargo itself that the documents may name.
const CARGO: [&str; 10] = ["add", "bench", "build", "clippy", "deny", "doc", "fmt", "install", "nextest", "test"];

#[test]
fn the_readme_names_the_two_commands_and_ci_calls_the_second() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(readme.contains("\ncargo demo\n") && readme.contains("\ncargo verify\n"), "one short line each");
    let ci = fs::read_to_string(root().join(".ci/run")).unwrap();
    assert!(ci.contains("cargo verify"));
}

#[test]
fn every_cargo_command_in_the_documents_exists() {
    let config = fs::read_to_string(root().join(".cargo/config.toml")).unwrap();
    let aliases: BTreeSet<&str> = config.lines().filter_map(|line| line.split(" = ").next()).collect();
    for (path, command) in commands("cargo ") {
        assert!(aliases.contains(command.as_str()) || CARGO.contains(&command.as_str()), "{path}: cargo {command}?");
    }
}

#[test]
fn every_terrane_command_in_the_documents_exists() {
    let help = Command::new(env!("CARGO_BIN_EXE_terrane")).arg("--help").output().unwrap();
    let help = String::from_utf8(help.stdout).unwrap();
    let listed = help.split_once("Commands:\n").expect("--help lists the commands").1;
    let listed = listed.lines().take_while(|line| !line.trim().is_empty());
    let listed: BTreeSet<String> = listed.filter_map(|line| Some(line.split_whitespace().next()?.to_owned())).collect();
    for (path, command) in commands("terrane ") {
        assert!(listed.contains(&command), "{path}: terrane {command}?");
    }
}

#[test]
fn links_between_documents_lead_somewhere() {
    for File { path, text } in with_endings(&["md"]) {
        let folder = root().join(&path);
        let folder = folder.parent().expect("a file has a folder");
        let targets = text.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next());
        for target in targets.filter(|target| !target.is_empty() && !target.contains("://")) {
            assert!(folder.join(target).exists(), "{path} links to {target}");
        }
    }
}

/// The word after `prefix`, wherever a line of a code block or a code span begins with it; with the document's path.
fn commands(prefix: &str) -> BTreeSet<(String, String)> {
    let mut found = BTreeSet::new();
    for File { path, text } in with_endings(&["md"]) {
        let starts = text.match_indices(prefix).filter(|(at, _)| *at > 0 && "\n`".contains(&text[at - 1..*at]));
        let rests = starts.map(|(at, _)| &text[at + prefix.len()..]);
        let words =
            rests.filter_map(|rest| rest.split(|letter: char| !letter.is_ascii_alphabetic() && letter != '-').next());
        found.extend(words.filter(|word| !word.is_empty()).map(|word| (path.clone(), word.to_owned())));
    }
    found
}
