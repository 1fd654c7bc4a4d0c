//! How numbers are spread, without keeping them.

/// Eighths of an octave from 2^-40 on.
const EIGHTHS: usize = 8 * 64;
const LEAST: f64 = -40.0;

/// Counts of distances by their logarithm.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    counts: Vec<u64>,
    max: f64,
}

impl Default for Histogram {
    fn default() -> Self {
        Self { counts: vec![0; EIGHTHS], max: 0.0 }
    }
}

impl Histogram {
    /// One more.
    pub(super) fn add(&mut self, distance: f64) {
        let eighth = (8.0 * (distance.log2() - LEAST)).floor().clamp(0.0, EIGHTHS as f64 - 1.0);
        self.counts[eighth as usize] += 1;
        self.max = self.max.max(distance);
    }

    /// Those of another as well.
    pub(super) fn join(&mut self, other: &Self) {
        for (count, more) in self.counts.iter_mut().zip(&other.counts) {
            *count += more;
        }
        self.max = self.max.max(other.max);
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.counts.iter().sum()
    }

    /// The largest.
    #[must_use]
    pub fn max(&self) -> f64 {
        self.max
    }

    /// What at least this share is not above; at most a tenth too large.
    #[must_use]
    pub fn quantile(&self, share: f64) -> f64 {
        let wanted = share * self.count() as f64;
        let mut sum = 0;
        let reached = self.counts.iter().position(|count| {
            sum += count;
            sum as f64 >= wanted
        });
        reached.map_or(0.0, |eighth| ((eighth as f64 + 1.0) / 8.0 + LEAST).exp2()).min(self.max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_near_and_not_below() {
        let (mut spread, mut other) = (Histogram::default(), Histogram::default());
        (1..=500).for_each(|number| spread.add(f64::from(number) * 1e-5));
        (501..=1000).for_each(|number| other.add(f64::from(number) * 1e-5));
        spread.join(&other);
        assert_eq!((spread.count(), spread.max()), (1000, 1e-2));
        for share in [0.1, 0.5, 0.999] {
            let (found, exact) = (spread.quantile(share), share * 1e-2);
            assert!(found >= exact && found <= 1.1 * exact, "{share}: {found}");
        }
        assert_eq!(Histogram::default().quantile(0.5), 0.0);
        spread.add(0.0);
        assert_eq!(spread.count(), 1001);
    }
}
