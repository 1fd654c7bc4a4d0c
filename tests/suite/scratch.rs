//! A copy of a project in a temporary folder, and the command line run in it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

/// The folder; it goes with this value.
pub(crate) struct Scratch(TempDir);

impl Scratch {
    /// A copy of what is written, not made, of a project in this repository.
    pub(crate) fn of(project: &str) -> Self {
        let folder = tempfile::tempdir().expect("a writable temporary folder");
        let project = Path::new(env!("CARGO_MANIFEST_DIR")).join(project);
        for part in ["terrane.ron", "graphs"] {
            copy(&project.join(part), &folder.path().join(part));
        }
        Self(folder)
    }

    /// A path in it.
    pub(crate) fn path(&self, inside: &str) -> PathBuf {
        self.0.path().join(inside)
    }

    /// Runs `terrane` in it.
    ///
    /// # Panics
    /// If the command fails.
    pub(crate) fn terrane(&self, arguments: &[&str]) {
        Self::succeed(&self.run(arguments), arguments);
    }

    /// Runs `terrane` in it, with variables of the environment.
    ///
    /// # Panics
    /// If the command fails.
    pub(crate) fn terrane_with(&self, variables: &[(&str, &str)], arguments: &[&str]) {
        let output = self.command(arguments).envs(variables.iter().copied()).output().expect("it can be started");
        Self::succeed(&output, arguments);
    }

    fn succeed(output: &Output, arguments: &[&str]) {
        assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    }

    /// Runs `terrane` in it, whatever comes of it.
    pub(crate) fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().expect("it can be started")
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut terrane = Command::new(env!("CARGO_BIN_EXE_terrane"));
        terrane.args(arguments).current_dir(self.0.path());
        terrane
    }
}

fn copy(from: &Path, to: &Path) {
    if from.is_file() {
        fs::copy(from, to).expect("a readable file");
        return;
    }
    fs::create_dir(to).expect("a new folder");
    for entry in fs::read_dir(from).expect("a readable folder") {
        let name = entry.expect("a readable folder").file_name();
        copy(&from.join(&name), &to.join(&name));
    }
}
