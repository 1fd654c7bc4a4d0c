//! What no file may contain, and what every WGSL file begins with.

use super::files::{File, with_endings};

#[test]
fn nothing_is_left_to_do() {
    // In two parts, so that this file does not find itself.
    forbid(&["rs"], &[concat!("to", "do!("), concat!("unimple", "mented!(")]);
}

#[test]
fn no_shader_switches_the_uniformity_analysis_off() {
    forbid(&["rs", "wgsl", "ron"], &[concat!("diagnostic", "(off")]);
}

#[test]
fn lines_end_with_a_line_feed() {
    for file in with_endings(&["rs", "wgsl", "ron", "md", "toml", "json", "mjs", "snap"]) {
        assert!(!file.text.contains('\r'), "{} has a carriage return", file.path);
        assert!(file.text.is_empty() || file.text.ends_with('\n'), "{} ends without a line feed", file.path);
    }
}

#[test]
fn every_library_file_says_what_it_is_and_where_it_comes_from() {
    for file in with_endings(&["wgsl"]).iter().filter(|file| file.path.starts_with("shaderlib/")) {
        let head: Vec<&str> = file.text.lines().take_while(|line| line.starts_with("//!")).collect();
        assert!(!head.is_empty(), "{} does not begin with `//!` and a sentence", file.path);
        let sourced = head.iter().any(|line| line.starts_with("//! Source:"));
        assert!(sourced || file.path.starts_with("shaderlib/hosts/"), "{} has no `//! Source:` line", file.path);
    }
}

fn forbid(endings: &[&str], words: &[&str]) {
    let found: Vec<String> = with_endings(endings).iter().flat_map(|file| hits(file, words)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

fn hits(file: &File, words: &[&str]) -> Vec<String> {
    let lines = file.text.lines().enumerate();
    let lines = lines.filter(|(_, line)| words.iter().any(|word| line.contains(word)));
    lines.map(|(at, line)| format!("{}:{}: {}", file.path, at + 1, line.trim())).collect()
}
