//! Tint, Chrome's WGSL compiler, as a second judge beside naga: it enforces uniformity and the limits of WebGPU.
//!
//! `tests/tint/validate.mjs` runs it in Node; one process judges thousands of modules, about 0.3 ms each.

mod pipelines;
#[cfg(test)]
mod tests;

use std::env;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::skip::Skip;

/// A running validator. It ends with this value.
pub(crate) struct Tint {
    child: Child,
    requests: ChildStdin,
    reports: BufReader<ChildStdout>,
}

/// A module to judge.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Module {
    /// Comes back in the report.
    pub(crate) name: String,
    /// The text.
    pub(crate) wgsl: String,
    /// The pipelines to create from it.
    pub(crate) pipelines: Vec<Pipeline>,
}

/// A pipeline to create: a vertex stage with or without a fragment stage, or a compute stage.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct Pipeline {
    /// Comes back in the report.
    pub(crate) name: String,
    /// `GPUVertexState` without its module.
    pub(crate) vertex: Option<Value>,
    /// `GPUFragmentState` without its module.
    pub(crate) fragment: Option<Value>,
    /// `GPUProgrammableStage` without its module.
    pub(crate) compute: Option<Value>,
    /// Arrays of `GPUBindGroupLayoutEntry`, group by group. Without them only the automatic layout is tried.
    pub(crate) layouts: Option<Value>,
}

/// What Tint said of a module.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct Report {
    /// The module's name.
    pub(crate) name: String,
    /// In the order of the text.
    pub(crate) messages: Vec<Message>,
    /// Empty if the module itself was refused.
    pub(crate) pipelines: Vec<Verdict>,
}

/// A message of the compiler.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct Message {
    /// `error`, `warning` or `info`.
    #[serde(rename = "type")]
    pub(crate) level: String,
    /// From 1; 0 if the message is about the whole module.
    pub(crate) line: u32,
    /// From 1, in UTF-16 units.
    pub(crate) column: u32,
    /// In words.
    pub(crate) text: String,
}

/// What came of one pipeline with one layout.
#[derive(Clone, Debug, Deserialize)]
pub(crate) struct Verdict {
    /// The pipeline's name.
    pub(crate) name: String,
    /// `auto` or `explicit`.
    pub(crate) layout: String,
    /// `None` if it was created.
    pub(crate) error: Option<String>,
}

impl Tint {
    /// Starts the validator.
    ///
    /// # Errors
    /// Why it cannot run here: no Node, or its packages are not installed.
    pub(crate) fn start() -> Result<Self, Skip> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/tint");
        if !folder.join("node_modules/webgpu").exists() {
            return Err(Skip("Tint: its packages are missing (cargo verify installs them into tests/tint)".into()));
        }
        let node =
            Command::new("node").arg(folder.join("validate.mjs")).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut child = node.map_err(|error| Skip(format!("Tint: `node` cannot be started: {error}")))?;
        let requests = child.stdin.take().expect("piped above");
        let reports = BufReader::new(child.stdout.take().expect("piped above"));
        Ok(Self { child, requests, reports })
    }

    /// One report for each module, in order.
    ///
    /// # Panics
    /// If the validator breaks down.
    pub(crate) fn validate(&mut self, modules: &[Module]) -> Vec<Report> {
        modules.iter().map(|module| self.judge(module)).collect()
    }

    /// Request and report in turn, so that neither pipe can fill up while nobody reads it.
    fn judge(&mut self, module: &Module) -> Report {
        let mut line = serde_json::to_string(module).expect("strings and JSON values");
        line.push('\n');
        let sent = self.requests.write_all(line.as_bytes());
        assert!(sent.is_ok(), "Tint broke down before `{}`; what it said stands above", module.name);
        let (said, answer) = self.answer(module);
        assert!(said.is_empty(), "Tint warns about `{}`: {said}", module.name);
        serde_json::from_str(&answer).unwrap_or_else(|error| panic!("Tint on `{}`: {error}: {answer}", module.name))
    }

    /// What Tint itself prints, which it does for warnings alone, and the line of the report behind it.
    fn answer(&mut self, module: &Module) -> (String, String) {
        let mut said = String::new();
        loop {
            let mut line = String::new();
            let length = self.reports.read_line(&mut line);
            let alive = length.is_ok_and(|length| length > 0);
            assert!(alive, "Tint broke down on `{}`; what it said stands above\n{said}", module.name);
            if line.starts_with('{') {
                return (said, line);
            }
            said.push_str(&line);
        }
    }
}

impl Drop for Tint {
    fn drop(&mut self) {
        // It would end by itself with its input; this way no test leaves a process behind.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Report {
    /// Everything that Tint refuses, one a line; empty if it accepts the module and every pipeline.
    pub(crate) fn errors(&self) -> String {
        let errors = self.messages.iter().filter(|message| message.level == "error");
        let errors =
            errors.map(|Message { line, column, text, .. }| format!("{}:{line}:{column}: {text}\n", self.name));
        let refused = self.pipelines.iter().filter_map(|Verdict { name, layout, error }| {
            error.as_ref().map(|error| format!("{}: pipeline {name}, {layout} layout: {error}\n", self.name))
        });
        errors.chain(refused).collect()
    }
}
