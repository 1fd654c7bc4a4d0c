//! Which results of a GPU are right.

use std::fmt;

use super::Probe;
use crate::machine::domain::accept::{Accept, Integers, Interval, Three};
use crate::machine::domain::{Cell, F32};
use crate::machine::{Component, Machine, MachineError, Value};

/// What became of a probe's results.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// How many words were judged.
    pub words: usize,
    /// How many of them would have been right whatever they were: where WGSL promises nothing.
    pub unbounded: usize,
    /// Those that no conforming implementation may give.
    pub rejected: Vec<Rejection>,
}

/// A result that is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rejection {
    /// Which point.
    pub point: usize,
    /// Which scalar of the result, in the order of its words.
    pub component: usize,
    /// The word that the GPU gave.
    pub found: u32,
    /// What it may have given.
    pub accepted: Accepted,
}

/// What a word may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accepted {
    /// An `f32`.
    Float(Interval),
    /// An `i32` or `u32`.
    Int(Integers),
    /// A `bool`, as 0 or 1.
    Truth(Three),
}

impl Accepted {
    /// Whether a word is acceptable.
    pub fn accepts(&self, word: u32) -> bool {
        match self {
            Self::Float(interval) => interval.accepts(f32::from_bits(word)),
            Self::Int(integers) => integers.accepts(word),
            Self::Truth(Three::Open) => word <= 1,
            Self::Truth(truth) => word == u32::from(*truth == Three::True),
        }
    }

    /// Whether every word is.
    pub fn is_unbounded(&self) -> bool {
        match self {
            Self::Float(interval) => interval.is_unbounded(),
            Self::Int(integers) => *integers == Integers::ANY,
            Self::Truth(truth) => *truth == Three::Open,
        }
    }
}

impl Probe {
    /// Judges the results that a GPU gave for arguments.
    ///
    /// # Errors
    /// If the machine cannot evaluate the function for them.
    ///
    /// # Panics
    /// If there are not as many results as points have words.
    pub fn judge(
        &self,
        machine: &Machine<'_>,
        arguments: &[Value<F32>],
        points: usize,
        results: &[u32],
    ) -> Result<Verdict, MachineError> {
        assert_eq!(results.len(), points * self.outputs, "words of {points} points");
        let arguments: Vec<Value<Accept>> = arguments.iter().map(Value::to).collect();
        let (accepted, _) = machine.call::<Accept>(&self.function, &arguments, points)?;
        let mut verdict = Verdict::default();
        for (at, found) in results.iter().enumerate() {
            let (point, component) = (at / self.outputs, at % self.outputs);
            let accepted = accepted_at(&accepted.components[component], point);
            verdict.words += 1;
            verdict.unbounded += usize::from(accepted.is_unbounded());
            if !accepted.accepts(*found) {
                verdict.rejected.push(Rejection { point, component, found: *found, accepted });
            }
        }
        Ok(verdict)
    }
}

fn accepted_at(component: &Component<Accept>, point: usize) -> Accepted {
    match component {
        Component::Float(values) => Accepted::Float(at(values, point)),
        Component::Int(values) => Accepted::Int(at(values, point)),
        Component::Truth(values) => Accepted::Truth(at(values, point)),
        Component::Handle(_) => unreachable!("no function returns a texture"),
    }
}

fn at<T: Cell>(values: &[T], point: usize) -> T {
    values[if values.len() == 1 { 0 } else { point }]
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { point, component, found, accepted } = self;
        write!(f, "point {point}, component {component}: ")?;
        match accepted {
            Accepted::Float(interval) => {
                let found = f32::from_bits(*found);
                write!(f, "{found:?} is not in {:?} ..= {:?}", interval.low(), interval.high())
            }
            Accepted::Int(integers) => write!(f, "{found} is not one of {integers}"),
            Accepted::Truth(truth) => write!(f, "{found} is not {truth:?}"),
        }
    }
}
