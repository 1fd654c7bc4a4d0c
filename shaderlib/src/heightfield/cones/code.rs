//! Positive numbers in 16 bits: five bits of exponent, eleven of mantissa.

/// A format: its code `c` stands for the f32 whose bits are `(c << 12) + (least + 127 << 23)`, so that a shader decodes it with
/// a shift and a sum. It reaches from 2^least to just below 2^(least + 32), in steps of at most 2^-11 of the number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    /// log2 of the smallest number.
    pub least: i32,
}

impl Format {
    /// The number of a code.
    #[must_use]
    pub fn value(self, code: u16) -> f32 {
        f32::from_bits(self.zero() + (u32::from(code) << 12))
    }

    /// The smallest code whose number is not below `value`; the last one if there is none.
    #[must_use]
    pub fn up(self, value: f64) -> u16 {
        let near = value as f32;
        let bits = near.to_bits() + u32::from(f64::from(near) < value);
        clamped(bits.saturating_sub(self.zero()).div_ceil(1 << 12))
    }

    /// The largest code whose number is not above `value`; 0 if there is none.
    #[must_use]
    pub fn down(self, value: f64) -> u16 {
        let near = value as f32;
        let bits = near.to_bits().saturating_sub(u32::from(f64::from(near) > value));
        clamped(bits.saturating_sub(self.zero()) >> 12)
    }

    fn zero(self) -> u32 {
        ((self.least + 127) as u32) << 23
    }
}

fn clamped(code: u32) -> u16 {
    u16::try_from(code).unwrap_or(u16::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMAT: Format = Format { least: -14 };

    #[test]
    fn every_code_is_the_code_of_its_number_and_numbers_grow() {
        for code in 0..=u16::MAX {
            let value = f64::from(FORMAT.value(code));
            assert_eq!((FORMAT.up(value), FORMAT.down(value)), (code, code));
            let next = value * (1.0 + 1e-12);
            assert_eq!((FORMAT.up(next), FORMAT.down(next)), (code.saturating_add(1), code));
        }
        assert_eq!([FORMAT.value(0), FORMAT.value(1 << 11)], [2_f32.powi(-14), 2_f32.powi(-13)]);
    }

    #[test]
    fn what_is_out_of_range_has_the_code_at_its_end() {
        assert_eq!([FORMAT.up(0.0), FORMAT.down(0.0), FORMAT.down(1e-30)], [0; 3]);
        assert_eq!([FORMAT.up(1e30), FORMAT.down(f64::INFINITY)], [u16::MAX; 2]);
    }
}
