//! Half floats: 1 sign bit, 5 exponent bits, 10 fraction bits, bias 15.

/// The bits of the half float nearest to x, ties to even; too large a number becomes infinity.
pub(super) fn to_bits(x: f64) -> u32 {
    let sign = if x.is_sign_negative() { 0x8000 } else { 0 };
    let magnitude = x.abs();
    if magnitude.is_nan() {
        return sign | 0x7e00;
    }
    // The spacing of half floats around x; subnormals share the spacing of the smallest normal ones.
    let spacing = libm::exp2(f64::from(libm::ilogb(magnitude.clamp(SMALLEST_NORMAL, 65536.0)) - 10));
    let rounded = (magnitude / spacing).round_ties_even() * spacing;
    if rounded >= 65536.0 {
        return sign | 0x7c00;
    }
    if rounded < SMALLEST_NORMAL {
        return sign | (rounded / SMALLEST_SUBNORMAL) as u32;
    }
    let exponent = libm::ilogb(rounded);
    let fraction = (rounded / libm::exp2(f64::from(exponent)) - 1.0) * 1024.0;
    sign | ((exponent + 15) as u32) << 10 | fraction as u32
}

/// The number of a half float in the low 16 bits.
pub(super) fn from_bits(bits: u32) -> f64 {
    let sign = if bits & 0x8000 == 0 { 1.0 } else { -1.0 };
    let exponent = (bits >> 10) & 31;
    let fraction = f64::from(bits & 1023);
    let magnitude = match exponent {
        0 => fraction * SMALLEST_SUBNORMAL,
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        _ => (1.0 + fraction / 1024.0) * libm::exp2(f64::from(exponent) - 15.0),
    };
    sign * magnitude
}

/// The largest half float that is not above x.
pub(super) fn down(x: f64) -> f64 {
    let bits = to_bits(x);
    let nearest = from_bits(bits);
    if nearest <= x {
        return nearest;
    }
    from_bits(match bits {
        0 | 0x8000 => 0x8001,
        0..0x8000 => bits - 1,
        _ => bits + 1,
    })
}

/// The smallest half float that is not below x.
pub(super) fn up(x: f64) -> f64 {
    -down(-x)
}

/// The largest finite one.
pub(super) const LARGEST: f64 = 65504.0;
/// 2^-14.
pub(super) const SMALLEST_NORMAL: f64 = 6.103_515_625e-5;
/// 2^-24.
const SMALLEST_SUBNORMAL: f64 = 5.960_464_477_539_063e-8;

#[cfg(test)]
mod tests {
    use super::{down, from_bits, to_bits, up};

    #[test]
    fn neighbours_enclose() {
        assert_eq!((down(1.0), up(1.0)), (1.0, 1.0));
        assert_eq!((down(1.0001), up(1.0001)), (1.0, 1.0 + 1.0 / 1024.0));
        assert_eq!((down(-1.0001), up(-1.0001)), (-1.0 - 1.0 / 1024.0, -1.0));
        assert_eq!((down(65510.0), up(65510.0)), (65504.0, f64::INFINITY));
        assert_eq!((down(1e-9), up(1e-9)), (0.0, super::SMALLEST_SUBNORMAL));
        assert_eq!((down(-1e-9), up(-1e-9)), (-super::SMALLEST_SUBNORMAL, 0.0));
    }

    #[test]
    fn every_half_float_survives_a_round_trip() {
        for bits in 0..0x1_0000 {
            let value = from_bits(bits);
            let expected = if value.is_nan() { (bits & 0x8000) | 0x7e00 } else { bits };
            assert_eq!(to_bits(value), expected, "{bits:#06x} is {value}");
        }
    }

    #[test]
    fn rounds_to_nearest_even() {
        assert_eq!(to_bits(1.0 + 1.0 / 2048.0), 0x3c00);
        assert_eq!(to_bits(1.0 + 3.0 / 2048.0), 0x3c02);
        assert_eq!(to_bits(65519.99), 0x7bff);
        assert_eq!(to_bits(65520.0), 0x7c00);
        assert_eq!(to_bits(2_f64.powi(-25)), 0);
        assert_eq!(to_bits(1.5 * 2_f64.powi(-25)), 1);
        assert_eq!(to_bits(-1.0e-30), 0x8000);
    }
}
