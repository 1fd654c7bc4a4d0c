//! One command of a longer run: a heading before it, its duration after it.

use std::ffi::OsStr;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Instant;
use std::{env, io};

/// The repository's root folder.
pub(crate) fn root() -> PathBuf {
    let xtask = env::var_os("CARGO_MANIFEST_DIR").expect("`cargo run` sets it to the folder of xtask");
    PathBuf::from(xtask).parent().expect("xtask lies in the repository's root").to_owned()
}

/// The cargo that runs us, called from the repository's root.
pub(crate) fn cargo(arguments: &[&str]) -> Command {
    command(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()), arguments)
}

/// Any program, called from the repository's root.
pub(crate) fn command(program: impl AsRef<OsStr>, arguments: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root()).stdin(Stdio::null());
    command
}

/// Prints a heading, runs `work`, prints how long it took.
pub(crate) fn step<T>(title: &str, work: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    println!("\n== {title}");
    let start = Instant::now();
    let result = work();
    let verdict = if result.is_ok() { "done" } else { "FAILED" };
    println!("-- {title}: {verdict} in {:.1} s", start.elapsed().as_secs_f64());
    result
}

/// Runs a command to its end, with its output on the terminal.
pub(crate) fn succeed(mut command: Command) -> Result<(), String> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("`{}` ended with {status}", words(&command))),
        Err(error) => Err(format!("`{}` cannot be started: {error}", words(&command))),
    }
}

/// What a program prints, or `None` if it is missing or fails. For asking what a machine has.
pub(crate) fn answer(program: &str, arguments: &[&str]) -> Option<String> {
    let output: io::Result<_> = command(program, arguments).stderr(Stdio::null()).output();
    let output = output.ok().filter(|output| output.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

fn words(command: &Command) -> String {
    let program = std::iter::once(command.get_program());
    program.chain(command.get_args()).map(OsStr::to_string_lossy).collect::<Vec<_>>().join(" ")
}
