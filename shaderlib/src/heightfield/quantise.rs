//! From heights of any kind to whole steps, which devices trace.

use super::heights::{Heights, Texels};

/// A map in whole steps over the map that it was made from: nowhere below it, and nowhere a step above.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantised {
    /// The map in 16-bit steps; one that had steps keeps them.
    pub heights: Heights,
    /// Height of step 0, a whole multiple of the step.
    pub low: f64,
    /// Height of a step: a power of two, so that no height in steps is rounded on its way back.
    pub step: f64,
}

/// The largest step that a height gets: one is left, since the lowest height is rounded down to a whole step.
const MOST: f64 = 65_534.0;

impl Quantised {
    /// Rounds every height up to a whole step. A surface between heights that are not below those of another is nowhere below
    /// it either: what bounds the one bounds both.
    #[must_use]
    pub fn new(heights: &Heights) -> Self {
        let Texels::F32(values) = heights.texels() else {
            return Self { heights: heights.clone(), low: 0.0, step: 1.0 };
        };
        let [lowest, highest] = values
            .iter()
            .fold([f64::MAX, f64::MIN], |[low, high], value| [low.min(f64::from(*value)), high.max(f64::from(*value))]);
        let step = step(highest - lowest);
        let low = (lowest / step).floor() * step;
        let texels = values.iter().map(|value| up(f64::from(*value), low, step)).collect();
        let heights = Heights::new(heights.size(), heights.border(), Texels::U16(texels))
            .expect("as many texels as the map of floats has, whose size is in range");
        Self { heights, low, step }
    }

    /// The height of a place that is so many steps high.
    #[must_use]
    pub fn height(&self, steps: f64) -> f64 {
        self.low + steps * self.step
    }
}

/// The smallest power of two of which the most steps make the range, but no subnormal one; 1 for a range of 0.
fn step(range: f64) -> f64 {
    if range == 0.0 {
        return 1.0;
    }
    let exponent = (range / MOST).log2().ceil() as i32;
    let step = 2_f64.powi(exponent.max(-1000));
    // The logarithm may have rounded down to a whole number.
    if range / step > MOST { 2.0 * step } else { step }
}

/// The least whole step that is not below a height.
fn up(height: f64, low: f64, step: f64) -> u16 {
    let steps = ((height - low) / step).ceil();
    // The difference may have rounded down to a whole number; the sum has few bits and does not round.
    let steps = if low + steps * step < height { steps + 1.0 } else { steps };
    // At most 65535, since no height is more than the range and a step above `low`.
    steps as u16
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::heightfield::adversary::Random;
    use crate::heightfield::{Border, pyramid};

    fn map(values: Vec<f32>) -> Heights {
        Heights::new([values.len() as u32, 1], Border::Wrap, Texels::F32(values)).expect("a map")
    }

    #[track_caller]
    fn holds(values: Vec<f32>) {
        let map = map(values.clone());
        let quantised = Quantised::new(&map);
        for (x, value) in values.iter().enumerate() {
            let over = quantised.height(quantised.heights.height(x as i64, 0)) - f64::from(*value);
            // Less than a step, which the difference may round to.
            assert!((0.0..=quantised.step).contains(&over), "{value}: {over} above, step {}", quantised.step);
        }
        let bound = pyramid::Pyramid::new(&quantised.heights, pyramid::Bound::CellMax);
        let true_bound = pyramid::Pyramid::new(&map, pyramid::Bound::CellMax);
        for x in 0..values.len() as u32 {
            assert!(quantised.height(bound.at(0, x, 0)) >= true_bound.at(0, x, 0), "cell {x}");
        }
    }

    #[test]
    fn heights_are_never_below_and_never_a_step_above() {
        holds(vec![0.0, 1.0, 0.3, -0.7]);
        holds(vec![1e-30, 1.0, -1e-30, 3.0e-39]);
        holds(vec![f32::MIN, f32::MAX, 0.0, 1.0]);
        holds(vec![1.0, 1.0 + f32::EPSILON, 1.0 + 3.0 * f32::EPSILON]);
        holds(vec![65_534.0, 0.0, 0.1, 65_533.1]);
        holds(vec![16_777_216.0, 16_777_215.0, 16_711_682.0]);
        let mut random = Random::new(5);
        for _ in 0..200 {
            let scale = 2_f64.powi(random.between(-60, 60) as i32);
            let shift = random.between(-1000, 1000) as f64;
            holds((0..16).map(|_| ((random.between(-1 << 30, 1 << 30) as f64 / 3e7 + shift) * scale) as f32).collect());
        }
    }

    #[test]
    fn a_flat_map_is_exact_and_whole_steps_stay() {
        let flat = Quantised::new(&map(vec![0.5; 3]));
        assert!(flat.height(flat.heights.height(1, 0)) - 0.5 < 1.0);
        let whole = Heights::new([2, 1], Border::Clamp, Texels::U8(vec![3, 9])).expect("a map");
        assert_eq!(Quantised::new(&whole), Quantised { heights: whole, low: 0.0, step: 1.0 });
    }
}
