//! The README's two commands, for a machine that has only Rust: they install what is missing or say how to.
//!
//! It has no dependencies, so that it is built in about a second and can set up what the real build needs.

mod demo;
mod setup;
mod step;
mod verify;
mod vulkan;

use std::env;
use std::process::ExitCode;

const USAGE: &str = "\
cargo demo
    Builds Terrane, renders graphs/scenes/alpine.ron and says where the picture is.

cargo verify [--quick] [--no-install] [--deny]
    Runs every check and every test.
    --quick       the tests only: no formatting, lints, documentation, licences or benchmarks
    --no-install  install nothing; a test that lacks something prints `skipped:` and says what
    --deny        install cargo-deny from source if it is missing (minutes); CI always does";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match dispatch(&words) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("\n{message}");
            ExitCode::FAILURE
        }
    }
}

fn dispatch(words: &[&str]) -> Result<(), String> {
    if words.iter().any(|word| ["help", "--help", "-h"].contains(word)) {
        println!("{USAGE}");
        return Ok(());
    }
    match words {
        ["demo"] => demo::run(),
        ["verify", options @ ..] => verify::run(&verify::Options::parse(options)?),
        _ => Err(format!("not understood: {}\n\n{USAGE}", words.join(" "))),
    }
}
