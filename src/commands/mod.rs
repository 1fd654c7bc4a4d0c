//! One file for each command. Results go to stdout, everything else to stderr.

mod build;
mod check;
mod measure;
mod new;
mod nodes;
mod project;
mod render;

use std::io::Write as _;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use terrane::render::RenderError;

/// Compiles terrain materials: RON node graphs in, specialised single-pass WGSL out.
#[derive(Debug, Parser)]
#[command(version, about, after_help = AFTER_HELP)]
pub(crate) struct Cli {
    /// Say on stderr how long each step took
    #[arg(short, long, global = true)]
    verbose: bool,
    #[command(subcommand)]
    command: Command,
}

const AFTER_HELP: &str = "\
Examples:
  terrane new my_terrain                                 start a project that works
  terrane check                                          find what is wrong with every graph of the project
  terrane render graphs/scenes/alpine.ron -o alpine.png  draw a scene
  terrane build graphs/terrains/alpine.ron -o out        write the WGSL and its manifest
  terrane measure --heightmap rock.png                   which relief method is fast enough, and how far off
  terrane nodes overlay                                  read about one node

Exit codes: 0 done, 1 the graphs are wrong, 2 the command line is wrong, 3 the machine or Terrane failed.";

#[derive(Debug, Subcommand)]
enum Command {
    New(new::New),
    Check(check::Check),
    Build(build::Build),
    Render(render::Render),
    Measure(measure::Measure),
    Nodes(nodes::Nodes),
}

impl Cli {
    /// Runs the command and says on stderr what went wrong.
    pub(crate) fn run(self) -> ExitCode {
        if self.verbose {
            let mut logger = env_logger::Builder::new();
            logger.filter_module("terrane", log::LevelFilter::Debug);
            logger.format(|line, record| writeln!(line, "{}", record.args())).init();
        }
        let result = match self.command {
            Command::New(command) => command.run(),
            Command::Check(command) => command.run(),
            Command::Build(command) => command.run(),
            Command::Render(command) => command.run(),
            Command::Measure(command) => command.run(),
            Command::Nodes(command) => command.run(),
        };
        match result {
            Ok(()) => ExitCode::SUCCESS,
            Err(failure) => failure.report(),
        }
    }
}

/// Why a command did not do what was asked.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The graphs are wrong; the text is the rendered report.
    Findings(String),
    /// The command line asks for what is not there.
    Usage(String),
    /// A file, a device or Terrane itself.
    Machine(String),
}

impl Failure {
    fn report(self) -> ExitCode {
        let (text, code) = match self {
            Self::Findings(report) => (report.trim_end().to_owned(), 1),
            Self::Usage(text) => (format!("error: {text}"), 2),
            Self::Machine(text) => (format!("error: {text}"), 3),
        };
        eprintln!("{text}");
        ExitCode::from(code)
    }

    /// A file that could not be read.
    pub(crate) fn unread(path: &std::path::Path, error: &std::io::Error) -> Self {
        Self::Machine(format!("cannot read {}: {error}", path.display()))
    }
}

impl From<terrane::file::Error> for Failure {
    fn from(error: terrane::file::Error) -> Self {
        Self::Machine(error.to_string())
    }
}

impl From<RenderError> for Failure {
    fn from(error: RenderError) -> Self {
        match error {
            RenderError::UnknownAdapter { .. } => Self::Usage(error.to_string()),
            other => Self::Machine(other.to_string()),
        }
    }
}
