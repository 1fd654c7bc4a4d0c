//! Texts and pictures that a person has looked at and accepted. `BLESS=1 cargo test --test suite accepted` accepts what
//! comes out now; without it a difference is a failure, and in CI nothing is ever accepted.

mod flip;
mod pictures;
mod schema;
mod texts;

use std::env;
use std::path::PathBuf;

/// How to accept, for messages.
const HOW: &str = "look at it; if it is right, accept it: BLESS=1 cargo test --test suite accepted";

fn blessing() -> bool {
    env::var_os("BLESS").is_some() && env::var_os("CI").is_none()
}

/// A file below `tests`.
fn accepted(path: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests").join(path)
}
