//! The pool of values and the making of equal ones the same.

use std::collections::BTreeMap;

use super::{Op, Origin, Value, ValueId};

/// Values, inputs before users, each with the nodes that it stands for.
#[derive(Clone, Debug, Default)]
pub struct Pool {
    values: Vec<Value>,
    origins: Vec<Vec<Origin>>,
    known: BTreeMap<Value, ValueId>,
    share: bool,
    asked: usize,
}

impl Pool {
    /// An empty pool. Without sharing every call is a value of its own.
    pub fn new(share: bool) -> Self {
        Self { share, ..Self::default() }
    }

    /// The value, new or known.
    pub fn add(&mut self, value: Value) -> ValueId {
        self.asked += usize::from(!value.is_inline());
        if (self.share || value.is_inline())
            && let Some(known) = self.known.get(&value)
        {
            return *known;
        }
        let id = ValueId(self.values.len());
        self.known.insert(value.clone(), id);
        self.values.push(value);
        self.origins.push(Vec::new());
        id
    }

    /// Notes that a node is this value.
    pub fn name(&mut self, id: ValueId, origin: Origin) {
        let origins = &mut self.origins[id.0];
        if !origins.contains(&origin) {
            origins.push(origin);
        }
    }

    /// A value of this pool.
    pub fn get(&self, id: ValueId) -> &Value {
        &self.values[id.0]
    }

    /// The nodes that a value stands for, the first one first.
    pub fn origins(&self, id: ValueId) -> &[Origin] {
        &self.origins[id.0]
    }

    /// Rewrites every op. Nothing may be added afterwards: equal values are no longer known.
    pub(super) fn replace(&mut self, new: impl Fn(&Op) -> Op) {
        self.known.clear();
        for value in &mut self.values {
            value.op = new(&value.op);
        }
    }

    /// Every id, inputs first.
    pub fn ids(&self) -> impl DoubleEndedIterator<Item = ValueId> + use<> {
        (0..self.values.len()).map(ValueId)
    }

    /// How many calls the graphs make, and how many values they became.
    pub fn counts(&self) -> (usize, usize) {
        (self.asked, self.values.iter().filter(|value| !value.is_inline()).count())
    }

    /// The literal that a value is, if it is one.
    pub fn literal(&self, id: ValueId) -> Option<crate::value::Literal> {
        match self.get(id).op {
            Op::Literal(literal) => Some(literal),
            _ => None,
        }
    }
}
