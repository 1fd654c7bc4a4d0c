//! Which materials meet on a patch, and the values that their shader needs, each under the guard that decides on it.

mod scope;
mod specialize;

use std::collections::BTreeSet;

use crate::program::{Program, ValueId};

pub use scope::{Scope, Scopes};
pub use specialize::specialize;

/// The layers that can occur on a patch, by their positions from the bottom.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Combination(pub BTreeSet<usize>);

impl Combination {
    /// Every layer of a terrain.
    pub fn all(program: &Program) -> Self {
        Self((0..program.layers.len()).collect())
    }
}

/// A combination ready to be written: dead layers are gone, every live value has its place.
#[derive(Clone, Debug)]
pub struct Specialization {
    /// What was asked for.
    pub combination: Combination,
    /// Positions of the layers that can be seen, bottom to top.
    pub layers: Vec<usize>,
    /// Live values by the guard that they stand under.
    pub scopes: Scopes,
    /// Whether guards are written.
    pub guard: bool,
    /// The surface outputs that differ between layers, and so must be blended.
    pub blended: BTreeSet<&'static str>,
    /// What tracing the displaced surface needs, where a visible layer has one.
    pub relief: Option<ReliefPart>,
    /// Everything that is computed or read, inputs first.
    pub live: BTreeSet<ValueId>,
}

/// The values of a displaced surface: all of them always run.
#[derive(Clone, Debug)]
pub struct ReliefPart {
    /// Masks, where the ray enters.
    pub masks: Scopes,
    /// Coordinates of the height maps.
    pub coordinates: Scopes,
}

impl ReliefPart {
    /// All of them.
    pub fn live(&self) -> BTreeSet<ValueId> {
        self.masks.live().into_iter().chain(self.coordinates.live()).collect()
    }
}
