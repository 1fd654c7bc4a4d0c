//! Numbers that are the same on every machine.

/// Pseudo-random numbers from a seed. Source: Steele, Lea and Flood, "Fast splittable pseudorandom number generators"
/// (2014), SplitMix64.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// A sequence of its own for each seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Any 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// A whole number from one to another, both included. The bias of the remainder does not matter here.
    pub fn between(&mut self, first: i64, last: i64) -> i64 {
        first + (self.bits() % ((last - first) as u64 + 1)) as i64
    }

    /// One of some, of which there is at least one.
    pub fn one_of<T: Copy>(&mut self, some: &[T]) -> T {
        some[self.between(0, some.len() as i64 - 1) as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_the_published_sequence() {
        let mut random = Random::new(1_234_567);
        assert_eq!([random.bits(), random.bits()], [6_457_827_717_110_365_317, 3_203_168_211_198_807_973]);
    }
}
