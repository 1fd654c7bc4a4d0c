//! Products of 128-bit integers, compared.

use std::cmp::Ordering;

/// Compares a b with c d, exactly: each product has 256 bits.
pub(super) fn compare(a: i128, b: i128, c: i128, d: i128) -> Ordering {
    match (a.checked_mul(b), c.checked_mul(d)) {
        (Some(first), Some(second)) => first.cmp(&second),
        _ => product(a, b).cmp(&product(c, d)),
    }
}

/// The upper and the lower half of a product in two's complement: in the order of the numbers themselves.
fn product(a: i128, b: i128) -> (i128, u128) {
    let (low, high) = (a as u128).carrying_mul(b as u128, 0);
    // A negative factor was read as itself + 2^128: that much of the other one is too much in the upper half.
    let excess = |factor: i128, other: i128| if factor < 0 { other } else { 0 };
    ((high as i128).wrapping_sub(excess(a, b)).wrapping_sub(excess(b, a)), low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_halves_are_those_of_the_product() {
        for (a, b) in [(7, -3), (-7, -3), (0, -5), (i128::from(i64::MAX), i128::from(i64::MIN))] {
            let whole: i128 = a * b;
            assert_eq!(product(a, b), (whole >> 127, whole as u128), "{a} × {b}");
        }
        assert_eq!(product(i128::MIN, i128::MIN), (1 << 126, 0));
        assert_eq!(product(i128::MIN, 1), (-1, 1 << 127));
        assert_eq!(product(i128::MAX, i128::MIN), ((i128::MIN + 1) >> 1, 1 << 127));
    }

    #[test]
    fn compares_what_does_not_fit_128_bits() {
        let large = 1_i128 << 100;
        assert_eq!(compare(large, large, large - 1, large + 1), Ordering::Greater);
        assert_eq!(compare(-large, large, large - 1, -large - 1), Ordering::Less);
        assert_eq!(compare(large, large, -large, -large), Ordering::Equal);
        assert_eq!(compare(large, -large, 3, 4), Ordering::Less);
    }
}
