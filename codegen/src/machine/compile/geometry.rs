//! Builtins of vectors, by the formulas from which WGSL's accuracy table derives their error (15.7.4.1).

use super::expression::lane_of;
use super::{Bank, Compiler};
use crate::machine::domain::{FloatBinary, FloatComparison, FloatUnary};

impl Compiler<'_> {
    /// `sqrt(dot(x, x))`; of a scalar, its magnitude.
    pub(super) fn length(&mut self, x: &[u32]) -> u32 {
        if let [x] = x {
            return self.float_unary(FloatUnary::Abs, *x);
        }
        let square = self.dot(x.to_vec(), x.to_vec());
        self.float_unary(FloatUnary::Sqrt, square)
    }

    pub(super) fn distance(&mut self, a: &[u32], b: &[u32]) -> u32 {
        let difference = self.each(FloatBinary::Subtract, a, b);
        self.length(&difference)
    }

    /// `x / length(x)`.
    pub(super) fn normalize(&mut self, x: &[u32]) -> Vec<u32> {
        let length = self.length(x);
        self.each(FloatBinary::Divide, x, &[length])
    }

    pub(super) fn cross(&mut self, a: &[u32], b: &[u32]) -> Vec<u32> {
        [(1, 2), (2, 0), (0, 1)]
            .into_iter()
            .map(|(i, j)| {
                let first = self.float_binary(FloatBinary::Multiply, a[i], b[j]);
                let second = self.float_binary(FloatBinary::Multiply, a[j], b[i]);
                self.float_binary(FloatBinary::Subtract, first, second)
            })
            .collect()
    }

    /// `e1 - 2 * dot(e2, e1) * e2`.
    pub(super) fn reflect(&mut self, e1: &[u32], e2: &[u32]) -> Vec<u32> {
        let along = self.dot(e2.to_vec(), e1.to_vec());
        let two = self.float_constant(2.0);
        let twice = self.float_binary(FloatBinary::Multiply, two, along);
        let offset = self.each(FloatBinary::Multiply, e2, &[twice]);
        self.each(FloatBinary::Subtract, e1, &offset)
    }

    /// `e3 * e1 - (e3 * dot(e2, e1) + sqrt(k)) * e2`, with `k = 1 - e3 * e3 * (1 - dot(e2, e1)^2)`; 0 where k < 0.
    pub(super) fn refract(&mut self, e1: &[u32], e2: &[u32], e3: u32) -> Vec<u32> {
        let (one, zero) = (self.float_constant(1.0), self.float_constant(0.0));
        let along = self.dot(e2.to_vec(), e1.to_vec());
        let square = self.float_binary(FloatBinary::Multiply, along, along);
        let rest = self.float_binary(FloatBinary::Subtract, one, square);
        let ratio = self.float_binary(FloatBinary::Multiply, e3, e3);
        let scaled = self.float_binary(FloatBinary::Multiply, ratio, rest);
        let k = self.float_binary(FloatBinary::Subtract, one, scaled);
        let root = self.float_unary(FloatUnary::Sqrt, k);
        let bent = self.float_binary(FloatBinary::Multiply, e3, along);
        let factor = self.float_binary(FloatBinary::Add, bent, root);
        let straight = self.each(FloatBinary::Multiply, e1, &[e3]);
        let sideways = self.each(FloatBinary::Multiply, e2, &[factor]);
        let refracted = self.each(FloatBinary::Subtract, &straight, &sideways);
        let reflected = self.float_comparison(FloatComparison::Less, k, zero);
        refracted.into_iter().map(|x| self.select(Bank::Float, reflected, zero, x)).collect()
    }

    /// `e1` where `dot(e2, e3) < 0`, else `-e1`.
    pub(super) fn face_forward(&mut self, e1: &[u32], e2: &[u32], e3: &[u32]) -> Vec<u32> {
        let zero = self.float_constant(0.0);
        let along = self.dot(e2.to_vec(), e3.to_vec());
        let facing = self.float_comparison(FloatComparison::Less, along, zero);
        e1.iter()
            .map(|x| {
                let turned = self.float_unary(FloatUnary::Negate, *x);
                self.select(Bank::Float, facing, *x, turned)
            })
            .collect()
    }

    /// Component by component; a scalar serves for all.
    pub(super) fn each(&mut self, op: FloatBinary, a: &[u32], b: &[u32]) -> Vec<u32> {
        (0..a.len().max(b.len())).map(|i| self.float_binary(op, lane_of(a, i), lane_of(b, i))).collect()
    }
}
