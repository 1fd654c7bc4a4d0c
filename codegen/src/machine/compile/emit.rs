//! Instructions, appended one by one: each takes operand registers and gives the register of its result.

use super::super::program::{Bank, Conversion, Instruction};
use super::Compiler;
use crate::machine::domain::{
    FloatBinary, FloatComparison, FloatTernary, FloatUnary, IntBinary, IntComparison, IntUnary, TruthBinary,
};

impl Compiler<'_> {
    fn append(&mut self, bank: Bank, instruction: impl FnOnce(u32) -> Instruction) -> u32 {
        let to = self.allocate(bank).index;
        self.pending.push(instruction(to));
        to
    }

    pub(super) fn copy(&mut self, bank: Bank, from: u32) -> u32 {
        self.append(bank, |to| Instruction::Copy { bank, to, from })
    }

    pub(super) fn float_unary(&mut self, op: FloatUnary, x: u32) -> u32 {
        self.append(Bank::Float, |to| Instruction::FloatUnary { op, to, x })
    }

    pub(super) fn float_binary(&mut self, op: FloatBinary, a: u32, b: u32) -> u32 {
        if op == FloatBinary::Multiply && a == b {
            return self.float_unary(FloatUnary::Square, a);
        }
        self.append(Bank::Float, |to| Instruction::FloatBinary { op, to, a, b })
    }

    pub(super) fn float_ternary(&mut self, op: FloatTernary, a: u32, b: u32, c: u32) -> u32 {
        self.append(Bank::Float, |to| Instruction::FloatTernary { op, to, a, b, c })
    }

    pub(super) fn float_comparison(&mut self, op: FloatComparison, a: u32, b: u32) -> u32 {
        self.append(Bank::Truth, |to| Instruction::FloatComparison { op, to, a, b })
    }

    pub(super) fn dot(&mut self, a: Vec<u32>, b: Vec<u32>) -> u32 {
        if a == b {
            return self.append(Bank::Float, |to| Instruction::SquareSum { to, x: a });
        }
        self.append(Bank::Float, |to| Instruction::Dot { to, a, b })
    }

    pub(super) fn int_unary(&mut self, op: IntUnary, x: u32) -> u32 {
        self.append(Bank::Int, |to| Instruction::IntUnary { op, to, x })
    }

    pub(super) fn int_binary(&mut self, op: IntBinary, a: u32, b: u32) -> u32 {
        self.append(Bank::Int, |to| Instruction::IntBinary { op, to, a, b })
    }

    pub(super) fn int_comparison(&mut self, op: IntComparison, a: u32, b: u32) -> u32 {
        self.append(Bank::Truth, |to| Instruction::IntComparison { op, to, a, b })
    }

    pub(super) fn not(&mut self, x: u32) -> u32 {
        self.append(Bank::Truth, |to| Instruction::Not { to, x })
    }

    pub(super) fn truth_binary(&mut self, op: TruthBinary, a: u32, b: u32) -> u32 {
        self.append(Bank::Truth, |to| Instruction::TruthBinary { op, to, a, b })
    }

    pub(super) fn select(&mut self, bank: Bank, condition: u32, accept: u32, reject: u32) -> u32 {
        self.append(bank, |to| Instruction::Select { bank, to, condition, accept, reject })
    }

    pub(super) fn convert(&mut self, op: Conversion, x: u32) -> u32 {
        let bank = match op {
            Conversion::FloatFromSigned
            | Conversion::FloatFromUnsigned
            | Conversion::FloatFromBits
            | Conversion::FloatFromHalf => Bank::Float,
            Conversion::SignedFromFloat
            | Conversion::UnsignedFromFloat
            | Conversion::BitsFromFloat
            | Conversion::HalfBits
            | Conversion::Exponent => Bank::Int,
        };
        self.append(bank, |to| Instruction::Convert { op, to, x })
    }

    pub(super) fn scale(&mut self, x: u32, exponent: u32) -> u32 {
        self.append(Bank::Float, |to| Instruction::Scale { to, x, exponent })
    }
}
