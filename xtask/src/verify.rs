//! `cargo verify`: every check and every test, in one run that does not stop at the first failure.

use std::process::Command;
use std::{env, fs};

use crate::setup::{self, Missing};
use crate::step::{answer, cargo, command, root, step, succeed};
use crate::vulkan;

/// What the user asked for.
#[derive(Debug, Default)]
pub(crate) struct Options {
    quick: bool,
    no_install: bool,
    deny: bool,
}

impl Options {
    /// # Errors
    /// A word that is no option, by name.
    pub(crate) fn parse(words: &[&str]) -> Result<Self, String> {
        let mut options = Self { deny: in_ci(), ..Self::default() };
        for word in words {
            match *word {
                "--quick" => options.quick = true,
                "--no-install" => options.no_install = true,
                "--deny" => options.deny = true,
                other => return Err(format!("not an option of cargo verify: {other} (see cargo verify --help)")),
            }
        }
        Ok(options)
    }
}

/// A check: its heading, and what to run.
type Check = (&'static str, fn() -> Result<(), String>);

/// Before the tests, so that a run ends with the test runner's own count.
const CHECKS: &[Check] = &[
    ("format", format),
    ("lint", lint),
    ("documentation", documentation),
    ("licences, bans, sources", deny),
    ("benchmarks, one iteration each", benches),
    ("documentation tests", doc_tests),
];

/// Runs the checks and the tests.
///
/// # Errors
/// What could not be installed, or the names of the checks that failed.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    if !options.no_install {
        install(options)?;
    }
    let checks = if options.quick { &[][..] } else { CHECKS };
    let mut failures = Vec::new();
    for (title, check) in checks.iter().copied().chain([("tests", tests as fn() -> _)]) {
        if let Err(error) = step(title, check) {
            eprintln!("{error}");
            failures.push(title);
        }
    }
    if failures.is_empty() { Ok(()) } else { Err(format!("cargo verify failed: {}", failures.join("; "))) }
}

fn in_ci() -> bool {
    env::var_os("CI").is_some()
}

fn install(options: &Options) -> Result<(), String> {
    let mut missing: Vec<Missing> = vulkan::missing().into_iter().collect();
    if answer("c++", &["--version"]).is_none() && !cfg!(windows) {
        missing.push(Missing { what: "a C++ compiler (for the image comparison of the tests)", packages: &["g++"] });
    }
    if answer("node", &["--version"]).is_none() {
        missing.push(Missing { what: "Node.js (for Tint, Chrome's WGSL compiler)", packages: &["nodejs"] });
    }
    if answer("npm", &["--version"]).is_none() {
        missing.push(Missing { what: "npm", packages: &["npm"] });
    }
    setup::install(&missing)?;
    install_tint()?;
    if options.deny && !options.quick && answer("cargo-deny", &["--version"]).is_none() {
        step("install cargo-deny", || succeed(cargo(&["install", "--locked", "cargo-deny"])))?;
    }
    Ok(())
}

/// Fetches the packages of `tests/tint`, unless those of its lock file are there already.
fn install_tint() -> Result<(), String> {
    let folder = root().join("tests/tint");
    let wanted = fs::read(folder.join("package-lock.json")).map_err(|error| format!("tests/tint: {error}"))?;
    let stamp = folder.join("node_modules/.installed-lock.json");
    if fs::read(&stamp).is_ok_and(|installed| installed == wanted) {
        return Ok(());
    }
    step("install Tint", || {
        let mut npm = command("npm", &["ci", "--ignore-scripts", "--no-audit", "--no-fund"]);
        npm.current_dir(&folder);
        succeed(npm)?;
        fs::write(&stamp, &wanted).map_err(|error| format!("{}: {error}", stamp.display()))
    })
}

fn format() -> Result<(), String> {
    if !has_component("fmt") {
        return leave_out("rustfmt is not installed (rustup component add rustfmt)");
    }
    succeed(cargo(&["fmt", "--all", "--check"]))
}

fn lint() -> Result<(), String> {
    if !has_component("clippy") {
        return leave_out("clippy is not installed (rustup component add clippy)");
    }
    succeed(cargo(&["clippy", "--workspace", "--all-targets", "--locked", "--keep-going", "--", "-D", "warnings"]))
}

fn documentation() -> Result<(), String> {
    let mut doc = cargo(&["doc", "--workspace", "--no-deps", "--locked", "--keep-going"]);
    doc.env("RUSTDOCFLAGS", "-D warnings");
    succeed(doc)
}

/// Without advisories: they need a git host, and change without a change of ours.
fn deny() -> Result<(), String> {
    if answer("cargo-deny", &["--version"]).is_none() {
        return leave_out("cargo-deny is not installed (cargo verify --deny installs it)");
    }
    succeed(cargo(&["deny", "--locked", "check", "licenses", "bans", "sources"]))
}

fn benches() -> Result<(), String> {
    // As a test and not with `cargo bench`: one iteration each, without a second build of everything in release.
    succeed(cargo(&["test", "--workspace", "--locked", "--bench", "*"]))
}

fn doc_tests() -> Result<(), String> {
    succeed(cargo(&["test", "--workspace", "--locked", "--doc"]))
}

fn tests() -> Result<(), String> {
    let skipped = env::temp_dir().join(format!("terrane-skipped-{}", std::process::id()));
    let mut runner = runner();
    runner.env("TERRANE_SKIPPED", &skipped);
    let result = succeed(runner);
    if let Ok(list) = fs::read_to_string(&skipped) {
        print!("{list}");
        let _ = fs::remove_file(&skipped);
    }
    result
}

/// nextest where it is installed, which runs the tests of all binaries at once; else cargo's own runner.
fn runner() -> Command {
    let targets = ["--workspace", "--locked", "--tests", "--no-fail-fast"];
    match answer("cargo-nextest", &["--version"]) {
        Some(_) => cargo(&[&["nextest", "run"][..], &targets].concat()),
        None => cargo(&[&["test"][..], &targets].concat()),
    }
}

/// Whether a part of the Rust toolchain is there, which a minimal toolchain lacks.
fn has_component(subcommand: &str) -> bool {
    cargo(&[subcommand, "--version"]).output().is_ok_and(|output| output.status.success())
}

/// Leaves a check out, which only a user's own machine may do.
fn leave_out(reason: &str) -> Result<(), String> {
    if in_ci() {
        return Err(reason.to_owned());
    }
    println!("skipped: {reason}");
    Ok(())
}
