//! What can stop an evaluation.

use std::fmt;

/// Why a function could not be evaluated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MachineError {
    /// The module has no function of this name.
    UnknownFunction {
        /// The name asked for.
        name: String,
    },
    /// The module has no texture or sampler variable of this name.
    UnknownGlobal {
        /// The name asked for.
        name: String,
    },
    /// Too many arguments, or too few.
    Arity {
        /// The function that was called.
        function: String,
        /// How many parameters it has.
        expected: usize,
        /// How many arguments it got.
        found: usize,
    },
    /// An argument does not have the type of its parameter, or not the right number of points.
    Argument {
        /// The function that was called.
        function: String,
        /// Which parameter, from 0.
        parameter: usize,
        /// What it wants.
        expected: String,
        /// What it got.
        found: String,
    },
    /// The function uses something that the machine does not evaluate.
    Unsupported {
        /// The function, or one that it calls.
        function: String,
        /// The expression, statement or type.
        construct: String,
    },
    /// A loop did not end.
    Endless {
        /// The function with the loop.
        function: String,
        /// How often the loop ran.
        iterations: u32,
    },
    /// The host knows no such texture.
    Texture {
        /// The function that reads it.
        function: String,
        /// The texture's id.
        texture: u32,
    },
}

impl fmt::Display for MachineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownFunction { name } => write!(f, "there is no function `{name}`"),
            Self::UnknownGlobal { name } => write!(f, "there is no texture or sampler variable `{name}`"),
            Self::Arity { function, expected, found } => {
                write!(f, "`{function}` takes {expected} arguments, not {found}")
            }
            Self::Argument { function, parameter, expected, found } => {
                write!(f, "parameter {parameter} of `{function}` is {expected}, the argument is {found}")
            }
            Self::Unsupported { function, construct } => write!(f, "`{function}` uses {construct}: not supported"),
            Self::Endless { function, iterations } => {
                write!(f, "a loop in `{function}` had not ended after {iterations} iterations")
            }
            Self::Texture { function, texture } => write!(f, "`{function}` reads texture {texture}, which is unknown"),
        }
    }
}

impl std::error::Error for MachineError {}
