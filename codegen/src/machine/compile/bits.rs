//! Bit fields, and numbers packed into 32 bits (WGSL 17.7, 17.8), by integer operations.

use naga::MathFunction;

use super::maths::{floats, integers};
use super::{Bank, Compiler, Register};
use crate::machine::domain::{FloatBinary, FloatTernary, FloatUnary, IntBinary, IntComparison};
use crate::machine::program::Conversion;

/// Numbers of a fixed width in a word, as fractions of a largest value.
struct Packing {
    width: u32,
    signed: bool,
    /// The number that stands for 1.
    one: f32,
}

impl Packing {
    fn of(fun: MathFunction) -> Option<Self> {
        Some(match fun {
            MathFunction::Pack4x8snorm | MathFunction::Unpack4x8snorm => Self { width: 8, signed: true, one: 127.0 },
            MathFunction::Pack4x8unorm | MathFunction::Unpack4x8unorm => Self { width: 8, signed: false, one: 255.0 },
            MathFunction::Pack2x16snorm | MathFunction::Unpack2x16snorm => {
                Self { width: 16, signed: true, one: 32767.0 }
            }
            MathFunction::Pack2x16unorm | MathFunction::Unpack2x16unorm => {
                Self { width: 16, signed: false, one: 65535.0 }
            }
            _ => return None,
        })
    }
}

impl Compiler<'_> {
    /// Floats to a word.
    pub(super) fn packing(&mut self, fun: MathFunction, x: &[u32]) -> Option<Vec<Register>> {
        let (width, parts): (u32, Vec<u32>) = match Packing::of(fun) {
            Some(packing) => (packing.width, x.iter().map(|x| self.normalised(&packing, *x)).collect()),
            None if fun == MathFunction::Pack2x16float => {
                (16, x.iter().map(|x| self.convert(Conversion::HalfBits, *x)).collect())
            }
            None => return None,
        };
        Some(integers([self.joined(width, &parts)]))
    }

    /// Integers to a word of bytes.
    pub(super) fn byte_packing(&mut self, fun: MathFunction, x: &[u32]) -> Option<Vec<Register>> {
        let (min, max, low, high) = match fun {
            MathFunction::Pack4xI8 | MathFunction::Pack4xU8 => return Some(integers([self.joined(8, x)])),
            MathFunction::Pack4xI8Clamp => (IntBinary::MinSigned, IntBinary::MaxSigned, -128_i32 as u32, 127),
            MathFunction::Pack4xU8Clamp => (IntBinary::Min, IntBinary::Max, 0, 255),
            _ => return None,
        };
        let (low, high) = (self.int_constant(low), self.int_constant(high));
        let raised = self.each_int(max, x, &[low]);
        let clamped = self.each_int(min, &raised, &[high]);
        Some(integers([self.joined(8, &clamped)]))
    }

    /// `floor(0.5 + one * clamp(x))` as an integer.
    fn normalised(&mut self, packing: &Packing, x: u32) -> u32 {
        let low = self.float_constant(if packing.signed { -1.0 } else { 0.0 });
        let (high, half, one) = (self.float_constant(1.0), self.float_constant(0.5), self.float_constant(packing.one));
        let clamped = self.float_ternary(FloatTernary::Clamp, x, low, high);
        let scaled = self.float_binary(FloatBinary::Multiply, clamped, one);
        let raised = self.float_binary(FloatBinary::Add, half, scaled);
        let whole = self.float_unary(FloatUnary::Floor, raised);
        self.convert(Conversion::SignedFromFloat, whole)
    }

    /// The low bits of each, the first one lowest.
    fn joined(&mut self, width: u32, parts: &[u32]) -> u32 {
        let mask = self.int_constant((1 << width) - 1);
        let mut word = self.int_constant(0);
        for (i, part) in parts.iter().enumerate() {
            let low = self.int_binary(IntBinary::And, *part, mask);
            let shift = self.int_constant(i as u32 * width);
            let placed = self.int_binary(IntBinary::ShiftLeft, low, shift);
            word = self.int_binary(IntBinary::Or, word, placed);
        }
        word
    }

    /// A word to floats or integers.
    pub(super) fn unpacking(&mut self, fun: MathFunction, word: u32) -> Option<Vec<Register>> {
        if let Some(packing) = Packing::of(fun) {
            let parts = self.split(packing.width, packing.signed, word);
            return Some(floats(parts.into_iter().map(|part| self.fraction(&packing, part))));
        }
        Some(match fun {
            MathFunction::Unpack2x16float => {
                let parts = self.split(16, false, word);
                floats(parts.into_iter().map(|part| self.convert(Conversion::FloatFromHalf, part)))
            }
            MathFunction::Unpack4xI8 => integers(self.split(8, true, word)),
            MathFunction::Unpack4xU8 => integers(self.split(8, false, word)),
            _ => return None,
        })
    }

    fn fraction(&mut self, packing: &Packing, part: u32) -> u32 {
        let op = if packing.signed { Conversion::FloatFromSigned } else { Conversion::FloatFromUnsigned };
        let (number, one) = (self.convert(op, part), self.float_constant(packing.one));
        let fraction = self.float_binary(FloatBinary::Divide, number, one);
        let lowest = self.float_constant(-1.0);
        self.float_binary(FloatBinary::Max, fraction, lowest)
    }

    fn split(&mut self, width: u32, signed: bool, word: u32) -> Vec<u32> {
        let down = self.int_constant(32 - width);
        let op = if signed { IntBinary::ShiftRightSigned } else { IntBinary::ShiftRight };
        (0..32 / width)
            .map(|i| {
                let up = self.int_constant(32 - width * (i + 1));
                let high = self.int_binary(IntBinary::ShiftLeft, word, up);
                self.int_binary(op, high, down)
            })
            .collect()
    }

    /// `count` bits from `offset`, both clamped to the word; signed numbers extend their highest bit.
    pub(super) fn extract_bits(&mut self, signed: bool, x: u32, offset: u32, count: u32) -> u32 {
        let (offset, count) = self.field(offset, count);
        let (zero, word) = (self.int_constant(0), self.int_constant(32));
        let unused = self.int_binary(IntBinary::Subtract, word, count);
        let above = self.int_binary(IntBinary::Subtract, unused, offset);
        let high = self.int_binary(IntBinary::ShiftLeft, x, above);
        let op = if signed { IntBinary::ShiftRightSigned } else { IntBinary::ShiftRight };
        let field = self.int_binary(op, high, unused);
        let empty = self.int_comparison(IntComparison::Equal, count, zero);
        self.select(Bank::Int, empty, zero, field)
    }

    /// x with `count` bits from `offset` replaced by the low bits of `field`.
    pub(super) fn insert_bits(&mut self, x: u32, field: u32, offset: u32, count: u32) -> u32 {
        let (offset, count) = self.field(offset, count);
        let (zero, word) = (self.int_constant(0), self.int_constant(32));
        let ones = self.int_constant(u32::MAX);
        let unused = self.int_binary(IntBinary::Subtract, word, count);
        let low = self.int_binary(IntBinary::ShiftRight, ones, unused);
        let mask = self.int_binary(IntBinary::ShiftLeft, low, offset);
        let placed = self.int_binary(IntBinary::ShiftLeft, field, offset);
        // x ^ ((x ^ placed) & mask) takes the bits of `placed` under the mask.
        let difference = self.int_binary(IntBinary::Xor, x, placed);
        let changed = self.int_binary(IntBinary::And, difference, mask);
        let result = self.int_binary(IntBinary::Xor, x, changed);
        let empty = self.int_comparison(IntComparison::Equal, count, zero);
        self.select(Bank::Int, empty, x, result)
    }

    /// Offset and count of a bit field, clamped to the word (WGSL 17.5.24).
    fn field(&mut self, offset: u32, count: u32) -> (u32, u32) {
        let word = self.int_constant(32);
        let offset = self.int_binary(IntBinary::Min, offset, word);
        let room = self.int_binary(IntBinary::Subtract, word, offset);
        let count = self.int_binary(IntBinary::Min, count, room);
        (offset, count)
    }
}
