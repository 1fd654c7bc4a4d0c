//! Conversions and bit casts.

use naga::{Expression, Handle, ScalarKind};

use super::super::program::Conversion;
use super::{Bank, Compiler, Register, Result};
use crate::machine::domain::{FloatComparison, IntComparison};

impl Compiler<'_> {
    /// `f32(x)`, `i32(x)` … or, unless `convert`, `bitcast`.
    pub(super) fn cast(&mut self, from: Handle<Expression>, to: ScalarKind, convert: bool) -> Result<Vec<Register>> {
        let Some(kind) = self.kind(from) else { return self.unsupported("a cast of a value that is no number") };
        let mut results = Vec::new();
        for part in self.value(from)? {
            let Some(result) = self.cast_scalar(part, kind, to, convert) else {
                return self.unsupported(format!("a cast from {kind:?} to {to:?}"));
            };
            results.push(result);
        }
        Ok(results)
    }

    fn cast_scalar(&mut self, x: Register, from: ScalarKind, to: ScalarKind, convert: bool) -> Option<Register> {
        use ScalarKind::{Bool, Float, Sint, Uint};
        let op = match (from, to, convert) {
            (Float, Float, _) | (Sint | Uint, Sint | Uint, _) | (Bool, Bool, _) => return Some(x),
            (Sint, Float, true) => Conversion::FloatFromSigned,
            (Uint, Float, true) => Conversion::FloatFromUnsigned,
            (Float, Sint, true) => Conversion::SignedFromFloat,
            (Float, Uint, true) => Conversion::UnsignedFromFloat,
            (Sint | Uint, Float, false) => Conversion::FloatFromBits,
            (Float, Sint | Uint, false) => Conversion::BitsFromFloat,
            (Bool, Float | Sint | Uint, true) => return Some(self.number_from_truth(x.index, to)),
            (Float | Sint | Uint, Bool, true) => return Some(self.truth_from_number(x)),
            _ => return None,
        };
        let bank = if to == Float { Bank::Float } else { Bank::Int };
        Some(Register { bank, index: self.convert(op, x.index) })
    }

    fn number_from_truth(&mut self, condition: u32, to: ScalarKind) -> Register {
        let (bank, one) = if to == ScalarKind::Float { (Bank::Float, 1.0_f32.to_bits()) } else { (Bank::Int, 1) };
        let (one, zero) = (self.constant(bank, one).index, self.constant(bank, 0).index);
        Register { bank, index: self.select(bank, condition, one, zero) }
    }

    fn truth_from_number(&mut self, x: Register) -> Register {
        let zero = self.constant(x.bank, 0).index;
        let index = match x.bank {
            Bank::Float => self.float_comparison(FloatComparison::NotEqual, x.index, zero),
            _ => self.int_comparison(IntComparison::NotEqual, x.index, zero),
        };
        Register { bank: Bank::Truth, index }
    }
}
