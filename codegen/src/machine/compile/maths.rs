//! The maths builtins, by their operands: floats, integers, packed bits.

use naga::{Expression, Handle, MathFunction};

use super::access::registers;
use super::expression::lane_of;
use super::{Bank, Compiler, Register, Result};
use crate::machine::domain::{FloatBinary, FloatTernary, FloatUnary, IntBinary, IntUnary};
use crate::machine::program::Conversion;

impl Compiler<'_> {
    pub(super) fn maths(&mut self, fun: MathFunction, arguments: &[Handle<Expression>]) -> Result<Vec<Register>> {
        if matches!(fun, MathFunction::Transpose) {
            return self.transpose(arguments[0]);
        }
        if matches!(fun, MathFunction::Determinant) {
            return self.determinant(arguments[0]);
        }
        let (float, signed) = (self.is_float(arguments[0]), self.is_signed(arguments[0]));
        let operands = arguments.iter().map(|argument| self.indices(*argument)).collect::<Result<Vec<_>>>()?;
        let found = if float {
            match self.float_maths(fun, &operands) {
                Some(results) => Some(results),
                None => self.packing(fun, &operands[0]),
            }
        } else {
            match self.int_maths(fun, signed, &operands) {
                Some(results) => Some(results),
                None => self.byte_packing(fun, &operands[0]).or_else(|| self.unpacking(fun, operands[0][0])),
            }
        };
        match found {
            Some(results) => Ok(results),
            None => self.unsupported(format!("the builtin {fun:?}")),
        }
    }

    fn float_maths(&mut self, fun: MathFunction, operands: &[Vec<u32>]) -> Option<Vec<Register>> {
        let x = &operands[0];
        if let Some(op) = unary(fun) {
            return Some(floats(x.iter().map(|x| self.float_unary(op, *x))));
        }
        if let Some(op) = binary(fun) {
            return Some(floats(self.each(op, x, &operands[1])));
        }
        if let Some(op) = ternary(fun) {
            let count = operands.iter().map(Vec::len).max()?;
            let at = |operand: usize, i: usize| lane_of(&operands[operand], i);
            return Some(floats((0..count).map(|i| self.float_ternary(op, at(0, i), at(1, i), at(2, i)))));
        }
        Some(match fun {
            MathFunction::Dot => floats([self.dot(x.clone(), operands[1].clone())]),
            MathFunction::Length => floats([self.length(x)]),
            MathFunction::Distance => floats([self.distance(x, &operands[1])]),
            MathFunction::Normalize => floats(self.normalize(x)),
            MathFunction::Cross => floats(self.cross(x, &operands[1])),
            MathFunction::Reflect => floats(self.reflect(x, &operands[1])),
            MathFunction::Refract => floats(self.refract(x, &operands[1], operands[2][0])),
            MathFunction::FaceForward => floats(self.face_forward(x, &operands[1], &operands[2])),
            MathFunction::Modf => self.modf(x),
            MathFunction::Frexp => self.frexp(x),
            MathFunction::Ldexp => floats((0..x.len()).map(|i| self.scale(x[i], lane_of(&operands[1], i)))),
            _ => return None,
        })
    }

    /// The fractions, then the whole numbers.
    fn modf(&mut self, x: &[u32]) -> Vec<Register> {
        let whole: Vec<u32> = x.iter().map(|x| self.float_unary(FloatUnary::Trunc, *x)).collect();
        let fraction = self.each(FloatBinary::Subtract, x, &whole);
        floats(fraction.into_iter().chain(whole))
    }

    /// The fractions, then the exponents.
    fn frexp(&mut self, x: &[u32]) -> Vec<Register> {
        let mut parts = floats(x.iter().map(|x| self.float_unary(FloatUnary::FrexpFraction, *x)));
        parts.extend(registers(Bank::Int, x.iter().map(|x| self.convert(Conversion::Exponent, *x))));
        parts
    }

    fn int_maths(&mut self, fun: MathFunction, signed: bool, operands: &[Vec<u32>]) -> Option<Vec<Register>> {
        let x = &operands[0];
        if let Some(op) = int_unary(fun, signed) {
            return Some(integers(x.iter().map(|x| self.int_unary(op, *x))));
        }
        let (low, high) =
            if signed { (IntBinary::MinSigned, IntBinary::MaxSigned) } else { (IntBinary::Min, IntBinary::Max) };
        Some(match fun {
            MathFunction::Abs => integers(x.iter().copied()),
            MathFunction::Min => integers(self.each_int(low, x, &operands[1])),
            MathFunction::Max => integers(self.each_int(high, x, &operands[1])),
            MathFunction::Clamp => {
                let raised = self.each_int(high, x, &operands[1]);
                integers(self.each_int(low, &raised, &operands[2]))
            }
            MathFunction::Dot => {
                let products = self.each_int(IntBinary::Multiply, x, &operands[1]);
                let sum = products[1..].iter().fold(products[0], |sum, x| self.int_binary(IntBinary::Add, sum, *x));
                integers([sum])
            }
            MathFunction::ExtractBits => {
                integers(x.iter().map(|x| self.extract_bits(signed, *x, operands[1][0], operands[2][0])))
            }
            MathFunction::InsertBits => {
                integers((0..x.len()).map(|i| self.insert_bits(x[i], operands[1][i], operands[2][0], operands[3][0])))
            }
            _ => return None,
        })
    }

    pub(super) fn each_int(&mut self, op: IntBinary, a: &[u32], b: &[u32]) -> Vec<u32> {
        (0..a.len().max(b.len())).map(|i| self.int_binary(op, lane_of(a, i), lane_of(b, i))).collect()
    }
}

pub(super) fn floats(indices: impl IntoIterator<Item = u32>) -> Vec<Register> {
    registers(Bank::Float, indices)
}

pub(super) fn integers(indices: impl IntoIterator<Item = u32>) -> Vec<Register> {
    registers(Bank::Int, indices)
}

fn unary(fun: MathFunction) -> Option<FloatUnary> {
    Some(match fun {
        MathFunction::Abs => FloatUnary::Abs,
        MathFunction::Saturate => FloatUnary::Saturate,
        MathFunction::Cos => FloatUnary::Cos,
        MathFunction::Cosh => FloatUnary::Cosh,
        MathFunction::Sin => FloatUnary::Sin,
        MathFunction::Sinh => FloatUnary::Sinh,
        MathFunction::Tan => FloatUnary::Tan,
        MathFunction::Tanh => FloatUnary::Tanh,
        MathFunction::Acos => FloatUnary::Acos,
        MathFunction::Asin => FloatUnary::Asin,
        MathFunction::Atan => FloatUnary::Atan,
        MathFunction::Asinh => FloatUnary::Asinh,
        MathFunction::Acosh => FloatUnary::Acosh,
        MathFunction::Atanh => FloatUnary::Atanh,
        MathFunction::Radians => FloatUnary::Radians,
        MathFunction::Degrees => FloatUnary::Degrees,
        MathFunction::Ceil => FloatUnary::Ceil,
        MathFunction::Floor => FloatUnary::Floor,
        MathFunction::Round => FloatUnary::Round,
        MathFunction::Fract => FloatUnary::Fract,
        MathFunction::Trunc => FloatUnary::Trunc,
        MathFunction::Exp => FloatUnary::Exp,
        MathFunction::Exp2 => FloatUnary::Exp2,
        MathFunction::Log => FloatUnary::Log,
        MathFunction::Log2 => FloatUnary::Log2,
        MathFunction::Sign => FloatUnary::Sign,
        MathFunction::Sqrt => FloatUnary::Sqrt,
        MathFunction::InverseSqrt => FloatUnary::InverseSqrt,
        MathFunction::QuantizeToF16 => FloatUnary::QuantizeToF16,
        _ => return None,
    })
}

fn binary(fun: MathFunction) -> Option<FloatBinary> {
    Some(match fun {
        MathFunction::Min => FloatBinary::Min,
        MathFunction::Max => FloatBinary::Max,
        MathFunction::Step => FloatBinary::Step,
        MathFunction::Pow => FloatBinary::Pow,
        MathFunction::Atan2 => FloatBinary::Atan2,
        _ => return None,
    })
}

fn ternary(fun: MathFunction) -> Option<FloatTernary> {
    Some(match fun {
        MathFunction::Clamp => FloatTernary::Clamp,
        MathFunction::Fma => FloatTernary::Fma,
        MathFunction::Mix => FloatTernary::Mix,
        MathFunction::SmoothStep => FloatTernary::SmoothStep,
        _ => return None,
    })
}

fn int_unary(fun: MathFunction, signed: bool) -> Option<IntUnary> {
    Some(match fun {
        MathFunction::Abs if signed => IntUnary::Abs,
        MathFunction::Sign if signed => IntUnary::Sign,
        MathFunction::CountTrailingZeros => IntUnary::CountTrailingZeros,
        MathFunction::CountLeadingZeros => IntUnary::CountLeadingZeros,
        MathFunction::CountOneBits => IntUnary::CountOneBits,
        MathFunction::ReverseBits => IntUnary::ReverseBits,
        MathFunction::FirstTrailingBit => IntUnary::FirstTrailingBit,
        MathFunction::FirstLeadingBit if signed => IntUnary::FirstLeadingBitSigned,
        MathFunction::FirstLeadingBit => IntUnary::FirstLeadingBit,
        _ => return None,
    })
}
