//! Times of several methods that were traced in turns.

use terrane_shaderlib::relief::Method;

/// For each method, what every round took.
#[derive(Clone, Debug)]
pub(super) struct Times(Vec<Vec<f64>>);

impl Times {
    /// For so many methods.
    pub(super) fn new(methods: usize) -> Self {
        Self(vec![Vec::new(); methods])
    }

    /// A round of a method.
    pub(super) fn add(&mut self, method: usize, time: f64) {
        self.0[method].push(time);
    }

    /// The middle of a method's rounds.
    pub(super) fn median(&self, method: usize) -> f64 {
        median(self.0[method].iter().copied())
    }

    /// A method over one of `methods`: the middle of what each round says, which what else the machine does hits less than
    /// times themselves.
    pub(super) fn ratio(&self, method: usize, base: Method, methods: &[Method]) -> f64 {
        methods.iter().position(|one| *one == base).map_or(f64::NAN, |base| self.over(method, base))
    }

    /// A method over the exact one that takes the least time of the first method's: a device's clock may not be the same all along.
    pub(super) fn over_exact(&self, method: usize, methods: &[Method]) -> f64 {
        let exact = (0..methods.len()).filter(|index| methods[*index].is_exact());
        let best = exact.min_by(|a, b| self.over(*a, 0).total_cmp(&self.over(*b, 0)));
        best.map_or(f64::NAN, |best| self.over(method, best))
    }

    fn over(&self, method: usize, base: usize) -> f64 {
        median(self.0[method].iter().zip(&self.0[base]).map(|(time, base)| time / base))
    }
}

fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_taken_within_rounds() {
        let methods = [Method::MaximumMipmaps, Method::Walk, Method::Linear(8, 0)];
        let mut times = Times::new(3);
        // The second round came while the machine did something else.
        for (round, slow) in [1.0, 7.0, 1.0].into_iter().enumerate() {
            times.add(0, 10.0 * slow);
            times.add(1, 5.0 * slow);
            times.add(2, (20.0 + round as f64) * slow);
        }
        assert_eq!(times.median(1), 5.0);
        assert_eq!(times.ratio(1, Method::MaximumMipmaps, &methods), 0.5);
        assert_eq!(times.ratio(2, Method::MaximumMipmaps, &methods), 2.1);
        assert_eq!(times.over_exact(2, &methods), 4.2);
        assert_eq!(times.over_exact(1, &methods), 1.0);
    }
}
