//! What can go wrong when content is made.

use std::fmt;
use std::path::PathBuf;

/// A failure while making content. Nothing is half written.
#[derive(Debug)]
pub enum Error {
    /// No recipe has this name.
    UnknownRecipe {
        /// The file that was to be made.
        key: String,
        /// The name.
        name: String,
    },
    /// The recipe has no such argument.
    UnknownArgument {
        /// The file that was to be made.
        key: String,
        /// The recipe.
        recipe: &'static str,
        /// The argument.
        argument: String,
    },
    /// An argument lies outside its range.
    OutOfRange {
        /// The file that was to be made.
        key: String,
        /// The argument.
        argument: &'static str,
        /// Its value.
        value: f64,
        /// Its range, inclusive.
        range: (f64, f64),
    },
    /// A file could not be written.
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownRecipe { key, name } => write!(f, "no recipe `{name}` to make `{key}` with"),
            Self::UnknownArgument { key, recipe, argument } => {
                write!(f, "recipe `{recipe}` of `{key}` has no argument `{argument}`")
            }
            Self::OutOfRange { key, argument, value, range: (low, high) } => {
                write!(f, "argument `{argument}` of `{key}` is {value}, its range is {low}..{high}")
            }
            Self::Write { path, source } => write!(f, "cannot write {}: {source}", path.display()),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Write { source, .. } => Some(source),
            Self::UnknownRecipe { .. } | Self::UnknownArgument { .. } | Self::OutOfRange { .. } => None,
        }
    }
}
