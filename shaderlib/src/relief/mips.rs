//! Coarser forms of a map of heights.

/// A texel of the next mip is the mean of the four that it covers, rounded; a side of 1 stays. Sides are powers of two.
pub(super) fn halve(texels: &[u16], [width, height]: [u32; 2]) -> Vec<u16> {
    let (columns, rows) = (width.div_ceil(2), height.div_ceil(2));
    let at = |x: u32, y: u32| u32::from(texels[(y.min(height - 1) * width + x.min(width - 1)) as usize]);
    let mean = |x: u32, y: u32| {
        let sum = at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) + at(2 * x + 1, 2 * y + 1);
        // At most 65535 again.
        ((sum + 2) / 4) as u16
    };
    (0..rows).flat_map(|y| (0..columns).map(move |x| mean(x, y))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_rounded_and_long_maps_keep_their_short_side() {
        assert_eq!(halve(&[0, 1, 1, 1], [2, 2]), [1]);
        assert_eq!(halve(&[65535; 4], [2, 2]), [65535]);
        assert_eq!(halve(&[2, 4, 10, 20], [4, 1]), [3, 15]);
    }
}
