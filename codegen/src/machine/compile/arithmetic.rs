//! Operators on scalars and vectors.

use naga::{BinaryOperator, Expression, Handle, ScalarKind, TypeInner, UnaryOperator};

use super::access::registers;
use super::expression::lane_of;
use super::{Bank, Compiler, Register, Result};
use crate::machine::domain::{
    FloatBinary, FloatComparison, FloatUnary, IntBinary, IntComparison, IntUnary, TruthBinary,
};

impl Compiler<'_> {
    pub(super) fn unary(&mut self, op: UnaryOperator, operand: Handle<Expression>) -> Result<Vec<Register>> {
        let float = self.is_float(operand);
        let bank = self.value(operand)?[0].bank;
        let parts = self.indices(operand)?;
        let results: Vec<u32> = parts
            .into_iter()
            .map(|x| match op {
                UnaryOperator::Negate if float => self.float_unary(FloatUnary::Negate, x),
                UnaryOperator::Negate => self.int_unary(IntUnary::Negate, x),
                UnaryOperator::LogicalNot => self.not(x),
                UnaryOperator::BitwiseNot => self.int_unary(IntUnary::Not, x),
            })
            .collect();
        Ok(registers(bank, results))
    }

    pub(super) fn binary(
        &mut self,
        op: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Result<Vec<Register>> {
        let is_matrix = |ty: &TypeInner| matches!(ty, TypeInner::Matrix { .. });
        if op == BinaryOperator::Multiply && (is_matrix(self.inner(left)) || is_matrix(self.inner(right))) {
            return self.matrix_product(left, right);
        }
        let kind = self.kind(left);
        let (a, b) = (self.indices(left)?, self.indices(right)?);
        let mut results = Vec::new();
        for i in 0..a.len().max(b.len()) {
            let (a, b) = (lane_of(&a, i), lane_of(&b, i));
            let Some(result) = self.scalar_binary(op, kind, a, b) else {
                return self.unsupported(format!("the operator {op:?} on {kind:?}"));
            };
            results.push(result);
        }
        Ok(results)
    }

    fn scalar_binary(&mut self, op: BinaryOperator, kind: Option<ScalarKind>, a: u32, b: u32) -> Option<Register> {
        let register = |bank, index| Some(Register { bank, index });
        match kind? {
            ScalarKind::Float => {
                if let Some(op) = float_operator(op) {
                    return register(Bank::Float, self.float_binary(op, a, b));
                }
                let (op, swapped) = float_comparison(op)?;
                let (a, b) = if swapped { (b, a) } else { (a, b) };
                register(Bank::Truth, self.float_comparison(op, a, b))
            }
            kind @ (ScalarKind::Sint | ScalarKind::Uint) => {
                let signed = kind == ScalarKind::Sint;
                if let Some(op) = int_operator(op, signed) {
                    return register(Bank::Int, self.int_binary(op, a, b));
                }
                let (op, swapped) = int_comparison(op, signed)?;
                let (a, b) = if swapped { (b, a) } else { (a, b) };
                register(Bank::Truth, self.int_comparison(op, a, b))
            }
            ScalarKind::Bool => register(Bank::Truth, self.truth_binary(truth_operator(op)?, a, b)),
            _ => None,
        }
    }
}

fn float_operator(op: BinaryOperator) -> Option<FloatBinary> {
    Some(match op {
        BinaryOperator::Add => FloatBinary::Add,
        BinaryOperator::Subtract => FloatBinary::Subtract,
        BinaryOperator::Multiply => FloatBinary::Multiply,
        BinaryOperator::Divide => FloatBinary::Divide,
        BinaryOperator::Modulo => FloatBinary::Remainder,
        _ => return None,
    })
}

/// The comparison, and whether the operands change places.
fn float_comparison(op: BinaryOperator) -> Option<(FloatComparison, bool)> {
    Some(match op {
        BinaryOperator::Equal => (FloatComparison::Equal, false),
        BinaryOperator::NotEqual => (FloatComparison::NotEqual, false),
        BinaryOperator::Less => (FloatComparison::Less, false),
        BinaryOperator::LessEqual => (FloatComparison::LessEqual, false),
        BinaryOperator::Greater => (FloatComparison::Less, true),
        BinaryOperator::GreaterEqual => (FloatComparison::LessEqual, true),
        _ => return None,
    })
}

fn int_operator(op: BinaryOperator, signed: bool) -> Option<IntBinary> {
    Some(match op {
        BinaryOperator::Add => IntBinary::Add,
        BinaryOperator::Subtract => IntBinary::Subtract,
        BinaryOperator::Multiply => IntBinary::Multiply,
        BinaryOperator::Divide if signed => IntBinary::DivideSigned,
        BinaryOperator::Divide => IntBinary::Divide,
        BinaryOperator::Modulo if signed => IntBinary::RemainderSigned,
        BinaryOperator::Modulo => IntBinary::Remainder,
        BinaryOperator::And => IntBinary::And,
        BinaryOperator::InclusiveOr => IntBinary::Or,
        BinaryOperator::ExclusiveOr => IntBinary::Xor,
        BinaryOperator::ShiftLeft => IntBinary::ShiftLeft,
        BinaryOperator::ShiftRight if signed => IntBinary::ShiftRightSigned,
        BinaryOperator::ShiftRight => IntBinary::ShiftRight,
        _ => return None,
    })
}

/// The comparison, and whether the operands change places.
fn int_comparison(op: BinaryOperator, signed: bool) -> Option<(IntComparison, bool)> {
    let less = if signed { IntComparison::LessSigned } else { IntComparison::Less };
    let less_equal = if signed { IntComparison::LessEqualSigned } else { IntComparison::LessEqual };
    Some(match op {
        BinaryOperator::Equal => (IntComparison::Equal, false),
        BinaryOperator::NotEqual => (IntComparison::NotEqual, false),
        BinaryOperator::Less => (less, false),
        BinaryOperator::LessEqual => (less_equal, false),
        BinaryOperator::Greater => (less, true),
        BinaryOperator::GreaterEqual => (less_equal, true),
        _ => return None,
    })
}

fn truth_operator(op: BinaryOperator) -> Option<TruthBinary> {
    Some(match op {
        BinaryOperator::And | BinaryOperator::LogicalAnd => TruthBinary::And,
        BinaryOperator::InclusiveOr | BinaryOperator::LogicalOr => TruthBinary::Or,
        BinaryOperator::Equal => TruthBinary::Equal,
        BinaryOperator::NotEqual => TruthBinary::NotEqual,
        _ => return None,
    })
}
