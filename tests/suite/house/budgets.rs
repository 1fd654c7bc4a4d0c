//! Lengths: a file near 130 lines and a function near 10 are the aim, these are the limits.

use super::files::with_endings;

const FILE_LINES: usize = 300;
const FUNCTION_LINES: usize = 50;

/// Files and functions (`path:name`) that are longer for a reason. One that is not longer any more must go from here.
const EXCEPTIONS: &[(&str, &str)] = &[];

#[test]
fn files_and_functions_are_short() {
    let mut long = Vec::new();
    // Snapshots are the generator's work, and as long as what they show.
    let written = |path: &str| !path.starts_with("tests/snapshots/");
    for file in with_endings(&["rs", "wgsl", "mjs"]).into_iter().filter(|file| written(&file.path)) {
        let lines = file.text.lines().count();
        if lines > FILE_LINES {
            long.push((file.path.clone(), lines));
        }
        let functions = functions(&file.text).into_iter().filter(|(_, lines)| *lines > FUNCTION_LINES);
        long.extend(functions.map(|(name, lines)| (format!("{}:{name}", file.path), lines)));
    }
    let excepted = |path: &str| EXCEPTIONS.iter().any(|(exception, _)| *exception == path);
    let over: Vec<_> = long.iter().filter(|(path, _)| !excepted(path)).collect();
    assert!(over.is_empty(), "longer than {FILE_LINES} lines (files) or {FUNCTION_LINES} (functions): {over:#?}");
    let stale = EXCEPTIONS.iter().filter(|(path, _)| !long.iter().any(|(found, _)| found == path));
    assert_eq!(stale.collect::<Vec<_>>(), Vec::<&(&str, &str)>::new(), "exceptions that are not needed any more");
}

/// Name and number of lines of each function. Formatted code closes a function with a brace under its first letter.
fn functions(text: &str) -> Vec<(String, usize)> {
    let lines: Vec<&str> = text.lines().collect();
    let starts = lines.iter().enumerate().filter_map(|(at, line)| Some((at, function_name(line)?)));
    starts.map(|(at, name)| (name.to_owned(), length(&lines[at..]))).collect()
}

fn function_name(line: &str) -> Option<&str> {
    let qualifiers = ["pub", "pub(crate)", "pub(super)", "const", "async", "extern", "unsafe"];
    let mut words = line.split_whitespace().skip_while(|word| qualifiers.contains(word));
    (words.next() == Some("fn")).then_some(())?;
    words.next()?.split(['(', '<']).next()
}

fn length(lines: &[&str]) -> usize {
    let indent = &lines[0][..lines[0].len() - lines[0].trim_start().len()];
    let closes = |line: &&str| line.strip_prefix(indent).is_some_and(|rest| rest.starts_with(['}', ')']) && ends(rest));
    if ends(lines[0]) {
        return 1;
    }
    lines.iter().skip(1).position(closes).map_or(lines.len(), |end| end + 2)
}

/// A body's closing brace, or the semicolon of a declaration without a body.
fn ends(line: &str) -> bool {
    line.ends_with(['}', ';'])
}

#[test]
fn counts_the_lines_of_functions() {
    let text = "\
impl A {
    pub(crate) const fn one(&self) -> u32 { 1 }
    fn three<T>(x: T) {
        if x { y }
    }
    fn declared(
        long: u32,
    ) -> u32;
}
fn six(
    long: u32,
) -> A {
    b();
    c()
}
";
    let expected =
        [("one", 1), ("three", 3), ("declared", 3), ("six", 6)].map(|(name, lines)| (name.to_owned(), lines));
    assert_eq!(functions(text), expected);
}
