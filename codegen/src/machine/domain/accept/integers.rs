//! Sets of 32-bit integers: a few values, or a range.

use std::fmt;

use super::super::{IntBinary, IntComparison};
use super::Three;

/// How many values are kept apart.
const FEW: usize = 8;

/// The values that an integer may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Integers {
    /// Ascending. The rest is 0.
    few: [u32; FEW],
    /// How many of them; 0 if it is a range.
    count: u8,
    /// Inclusive, unsigned.
    range: (u32, u32),
}

impl Default for Integers {
    fn default() -> Self {
        Self::one(0)
    }
}

impl Integers {
    /// Any value at all.
    pub const ANY: Self = Self { few: [0; FEW], count: 0, range: (0, u32::MAX) };

    /// A value that is known.
    pub fn one(value: u32) -> Self {
        let mut few = [0; FEW];
        few[0] = value;
        Self { few, count: 1, range: (value, value) }
    }

    /// All values from one to another, as unsigned numbers.
    pub fn range(low: u32, high: u32) -> Self {
        if high - low < FEW as u32 {
            return Self::of(low..=high);
        }
        Self { range: (low, high), ..Self::ANY }
    }

    /// These values, of which there is at least one.
    pub fn of(values: impl IntoIterator<Item = u32>) -> Self {
        let mut all: Vec<u32> = values.into_iter().collect();
        all.sort_unstable();
        all.dedup();
        let (Some(low), Some(high)) = (all.first(), all.last()) else { return Self::ANY };
        let range = (*low, *high);
        if all.len() > FEW {
            return Self { range, ..Self::ANY };
        }
        let mut few = [0; FEW];
        few[..all.len()].copy_from_slice(&all);
        Self { few, count: all.len() as u8, range }
    }

    /// The values, if they are few.
    pub fn values(&self) -> Option<&[u32]> {
        (self.count > 0).then(|| &self.few[..usize::from(self.count)])
    }

    /// The lowest and the highest value, as unsigned numbers.
    pub fn bounds(&self) -> (u32, u32) {
        self.range
    }

    /// The lowest and the highest value, as signed numbers.
    pub fn signed_bounds(&self) -> (i32, i32) {
        if let Some(values) = self.values() {
            let signed = || values.iter().map(|value| *value as i32);
            return (signed().min().unwrap_or(i32::MIN), signed().max().unwrap_or(i32::MAX));
        }
        let (low, high) = (self.range.0 as i32, self.range.1 as i32);
        // A range that holds both signs holds the largest and the smallest number.
        if low <= high { (low, high) } else { (i32::MIN, i32::MAX) }
    }

    /// Whether a value is among them.
    pub fn accepts(&self, value: u32) -> bool {
        match self.values() {
            Some(values) => values.contains(&value),
            None => self.range.0 <= value && value <= self.range.1,
        }
    }

    /// The values of both.
    pub fn join(self, other: Self) -> Self {
        match (self.values(), other.values()) {
            (Some(a), Some(b)) => Self::of(a.iter().chain(b).copied()),
            _ => Self::range(self.range.0.min(other.range.0), self.range.1.max(other.range.1)),
        }
    }

    /// The results of a function.
    pub(super) fn map(self, f: impl Fn(u32) -> u32) -> Self {
        match self.values() {
            Some(values) => Self::of(values.iter().map(|value| f(*value))),
            None => Self::ANY,
        }
    }

    /// The results of an operation.
    pub(super) fn combine(self, op: IntBinary, other: Self) -> Self {
        match (self.values(), other.values()) {
            (Some([a]), Some([b])) => Self::one(op.apply(*a, *b)),
            (Some(a), Some(b)) => Self::of(a.iter().flat_map(|a| b.iter().map(|b| op.apply(*a, *b)))),
            _ => self.combine_ranges(op, other),
        }
    }

    /// What is easily known of ranges: unsigned operations that cannot wrap.
    fn combine_ranges(self, op: IntBinary, other: Self) -> Self {
        let ((a_low, a_high), (b_low, b_high)) = (self.range, other.range);
        let range = |low: Option<u32>, high: Option<u32>| match (low, high) {
            (Some(low), Some(high)) => Self::range(low, high),
            _ => Self::ANY,
        };
        match op {
            IntBinary::Add => range(a_low.checked_add(b_low), a_high.checked_add(b_high)),
            IntBinary::Subtract => range(a_low.checked_sub(b_high), a_high.checked_sub(b_low)),
            IntBinary::Multiply => range(a_low.checked_mul(b_low), a_high.checked_mul(b_high)),
            IntBinary::Divide if b_low > 0 => Self::range(a_low / b_high, a_high / b_low),
            IntBinary::Remainder if b_low > 0 => Self::range(0, a_high.min(b_high - 1)),
            IntBinary::And => Self::masked(self, other),
            IntBinary::ShiftRight if b_low == b_high => Self::range(a_low >> (b_low & 31), a_high >> (b_low & 31)),
            IntBinary::Min => Self::range(a_low.min(b_low), a_high.min(b_high)),
            IntBinary::Max => Self::range(a_low.max(b_low), a_high.max(b_high)),
            _ => Self::ANY,
        }
    }

    /// A mask of few bits leaves few values.
    fn masked(a: Self, b: Self) -> Self {
        let mask = match (a.values(), b.values()) {
            (Some([mask]), _) | (_, Some([mask])) => *mask,
            _ => return Self::range(0, a.range.1.min(b.range.1)),
        };
        if mask.count_ones() > FEW.ilog2() {
            return Self::range(0, mask.min(a.range.1).min(b.range.1));
        }
        let mut values = vec![0];
        for bit in (0..32).map(|bit| 1 << bit).filter(|bit| mask & bit != 0) {
            values.extend(values.clone().iter().map(|value| value | bit));
        }
        Self::of(values)
    }

    /// Whether a comparison holds.
    pub(super) fn compare(self, op: IntComparison, other: Self) -> Three {
        if let (Some(a), Some(b)) = (self.values(), other.values()) {
            let results = || a.iter().flat_map(|a| b.iter().map(|b| op.apply(*a, *b)));
            return Three::of(results().all(|holds| holds), !results().any(|holds| holds));
        }
        let (a, b) = (self.range, other.range);
        let (c, d) = (self.signed_bounds(), other.signed_bounds());
        let disjoint = a.1 < b.0 || b.1 < a.0;
        match op {
            IntComparison::Equal => Three::of(false, disjoint),
            IntComparison::NotEqual => Three::of(disjoint, false),
            IntComparison::Less => Three::of(a.1 < b.0, a.0 >= b.1),
            IntComparison::LessEqual => Three::of(a.1 <= b.0, a.0 > b.1),
            IntComparison::LessSigned => Three::of(c.1 < d.0, c.0 >= d.1),
            IntComparison::LessEqualSigned => Three::of(c.1 <= d.0, c.0 > d.1),
        }
    }
}

impl fmt::Display for Integers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.values() {
            Some(values) => write!(f, "{values:?}"),
            None => write!(f, "{} ..= {}", self.range.0, self.range.1),
        }
    }
}
