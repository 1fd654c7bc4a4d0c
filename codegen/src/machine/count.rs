//! Cost without a clock: how many operations of each class a call executed.

use std::ops::AddAssign;

/// Operations executed, each counted once per active point. A vector operation counts once per component.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Additions, multiplications, roundings, minima …: what a GPU does in one cycle.
    pub arithmetic: u64,
    /// Divisions, remainders, square roots and reciprocal ones.
    pub division: u64,
    /// Exponentials, logarithms, powers, trigonometry.
    pub transcendental: u64,
    /// On integers and bits.
    pub integer: u64,
    /// Comparisons, selections, logic.
    pub decision: u64,
    /// Conversions between types.
    pub conversion: u64,
    /// Reads of array elements by a computed index.
    pub indexed: u64,
    /// `textureLoad`.
    pub texture_loads: u64,
    /// `textureSampleLevel`, `textureSampleGrad`.
    pub texture_samples: u64,
    /// `if` and `switch`.
    pub branches: u64,
    /// Turns of loops.
    pub iterations: u64,
    /// Calls of functions.
    pub calls: u64,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        let Self {
            arithmetic,
            division,
            transcendental,
            integer,
            decision,
            conversion,
            indexed,
            texture_loads,
            texture_samples,
            branches,
            iterations,
            calls,
        } = other;
        self.arithmetic += arithmetic;
        self.division += division;
        self.transcendental += transcendental;
        self.integer += integer;
        self.decision += decision;
        self.conversion += conversion;
        self.indexed += indexed;
        self.texture_loads += texture_loads;
        self.texture_samples += texture_samples;
        self.branches += branches;
        self.iterations += iterations;
        self.calls += calls;
    }
}
