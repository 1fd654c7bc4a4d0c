//! A test that cannot run here says so; where everything must run, it fails.

use std::fs::OpenOptions;
use std::io::Write as _;
use std::{env, io};

/// Why a test cannot run on this machine.
#[derive(Debug)]
pub(crate) struct Skip(pub(crate) String);

impl Skip {
    /// Ends a test early: `let Ok(tint) = … else { return skip.report() }`.
    ///
    /// # Panics
    /// With the environment variable `CI` set, where a skip is a failure.
    #[track_caller]
    pub(crate) fn report(self) {
        assert!(env::var_os("CI").is_none(), "skipped, which CI does not allow: {}", self.0);
        let line = format!("skipped: {}\n", self.0);
        // Past the runner's capture of a passing test's output; nextest holds that back too, so `cargo verify` names a
        // file which it prints at the end. A message that cannot be written must not fail the test.
        let _ = io::stderr().write_all(line.as_bytes());
        if let Some(file) = env::var_os("TERRANE_SKIPPED") {
            let file = OpenOptions::new().create(true).append(true).open(file);
            let _ = file.and_then(|mut file| file.write_all(line.as_bytes()));
        }
    }
}
