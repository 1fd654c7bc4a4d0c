//! WGSL's integer arithmetic on 32 bits: wrapping, total, the same in every domain (WGSL 8.7, 8.8, 17.5).

use super::{IntBinary, IntComparison, IntUnary};

impl IntUnary {
    /// The operation on one number.
    #[inline(always)]
    pub fn apply(self, x: u32) -> u32 {
        match self {
            Self::Negate => x.wrapping_neg(),
            Self::Not => !x,
            Self::Abs => (x as i32).wrapping_abs() as u32,
            Self::Sign => (x as i32).signum() as u32,
            Self::CountLeadingZeros => x.leading_zeros(),
            Self::CountTrailingZeros => x.trailing_zeros(),
            Self::CountOneBits => x.count_ones(),
            Self::ReverseBits => x.reverse_bits(),
            Self::FirstLeadingBitSigned => highest(if (x as i32) < 0 { !x } else { x }),
            Self::FirstLeadingBit => highest(x),
            Self::FirstTrailingBit => lowest(x),
        }
    }
}

fn highest(x: u32) -> u32 {
    31_u32.wrapping_sub(x.leading_zeros())
}

fn lowest(x: u32) -> u32 {
    if x == 0 { u32::MAX } else { x.trailing_zeros() }
}

impl IntBinary {
    /// The operation on two numbers.
    #[inline(always)]
    pub fn apply(self, a: u32, b: u32) -> u32 {
        match self {
            Self::Add => a.wrapping_add(b),
            Self::Subtract => a.wrapping_sub(b),
            Self::Multiply => a.wrapping_mul(b),
            Self::DivideSigned => (a as i32).checked_div(b as i32).map_or(a, |q| q as u32),
            Self::Divide => a.checked_div(b).unwrap_or(a),
            Self::RemainderSigned => (a as i32).checked_rem(b as i32).map_or(0, |r| r as u32),
            Self::Remainder => a.checked_rem(b).unwrap_or(0),
            Self::And => a & b,
            Self::Or => a | b,
            Self::Xor => a ^ b,
            Self::ShiftLeft => a << (b & 31),
            Self::ShiftRightSigned => ((a as i32) >> (b & 31)) as u32,
            Self::ShiftRight => a >> (b & 31),
            Self::MinSigned => (a as i32).min(b as i32) as u32,
            Self::Min => a.min(b),
            Self::MaxSigned => (a as i32).max(b as i32) as u32,
            Self::Max => a.max(b),
        }
    }
}

impl IntComparison {
    /// Whether it holds.
    #[inline(always)]
    pub fn apply(self, a: u32, b: u32) -> bool {
        match self {
            Self::Equal => a == b,
            Self::NotEqual => a != b,
            Self::LessSigned => (a as i32) < (b as i32),
            Self::Less => a < b,
            Self::LessEqualSigned => (a as i32) <= (b as i32),
            Self::LessEqual => a <= b,
        }
    }
}
