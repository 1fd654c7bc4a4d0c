//! Guards, and the place of each value among them.
//!
//! A value stands in the innermost scope that holds all its uses: their nearest common dominator. A value that two
//! layers share is thus computed before both of their guards, and never read where it was not computed.

use std::collections::{BTreeMap, BTreeSet};

use crate::program::{Pool, ValueId};

/// A region of the shader.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Scope {
    /// Always run.
    Root,
    /// What lies at or below a layer, where something is left to be covered. The number counts visible layers from the bottom.
    Cover(usize),
    /// The height of a layer, where its mask lets it take part.
    Weigh(usize),
    /// The look of a layer, where it can be seen.
    Paint(usize),
}

/// Which scope each live value stands in.
#[derive(Clone, Debug, Default)]
pub struct Scopes {
    parents: BTreeMap<Scope, Scope>,
    of: BTreeMap<ValueId, Scope>,
    uses: BTreeMap<ValueId, BTreeSet<Scope>>,
}

impl Scopes {
    /// A tree of scopes given by the parent of each but the root.
    pub fn new(parents: BTreeMap<Scope, Scope>) -> Self {
        Self { parents, ..Self::default() }
    }

    /// Notes that a scope reads a value.
    pub(super) fn demand(&mut self, value: ValueId, scope: Scope) {
        let place = self.of.get(&value).map_or(scope, |known| self.common(*known, scope));
        self.of.insert(value, place);
        self.uses.entry(value).or_default().insert(scope);
    }

    /// Carries every demand to the inputs, users before inputs.
    pub(super) fn settle(&mut self, pool: &Pool) {
        for id in pool.ids().rev() {
            let Some(scope) = self.of.get(&id).copied() else { continue };
            let value = pool.get(id);
            // What is written at its uses hands the uses on; what has a name is read where it stands.
            let scopes = if value.is_inline() { self.uses[&id].clone() } else { BTreeSet::from([scope]) };
            for input in &value.inputs {
                for scope in &scopes {
                    self.demand(*input, *scope);
                }
            }
        }
    }

    /// Everything that is needed.
    pub fn live(&self) -> BTreeSet<ValueId> {
        self.of.keys().copied().collect()
    }

    /// The named values that stand in a scope, inputs first.
    pub fn values(&self, pool: &Pool, scope: Scope) -> Vec<ValueId> {
        let here = self.of.iter().filter(|(id, place)| **place == scope && !pool.get(**id).is_inline());
        here.map(|(id, _)| *id).collect()
    }

    /// The values of `from` that a later block of another scope reads.
    pub fn exports(&self, pool: &Pool, from: Scope) -> Vec<ValueId> {
        let outside = |id: &ValueId| self.uses[id].iter().any(|scope| *scope != from);
        self.values(pool, from).into_iter().filter(outside).collect()
    }

    fn common(&self, a: Scope, b: Scope) -> Scope {
        let above = self.path(a);
        self.path(b).into_iter().find(|scope| above.contains(scope)).unwrap_or(Scope::Root)
    }

    /// From a scope to the root.
    fn path(&self, scope: Scope) -> Vec<Scope> {
        std::iter::successors(Some(scope), |scope| self.parents.get(scope).copied()).collect()
    }
}
