//! Integer hashes and the random numbers made of them: the same on every machine.

/// Spreads every bit of `x` over all bits of the result.
/// Source: Wellons, "Prospecting for Hash Functions", 2018, `lowbias32`.
pub fn mix(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// A hash of a seed and two whole numbers.
pub fn hash(seed: u32, x: u32, y: u32) -> u32 {
    mix(x ^ mix(y.wrapping_add(seed.wrapping_mul(0x9e37_79b9))))
}

/// 0 included, 1 excluded, from the upper 24 bits.
pub fn unit(bits: u32) -> f32 {
    (bits >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// A stream of random numbers: the n-th number is a hash of n.
#[derive(Clone, Debug)]
pub struct Random {
    seed: u32,
    count: u32,
}

impl Random {
    /// The stream that belongs to one thing among many of a kind.
    pub fn new(seed: u32, index: u32) -> Self {
        Self { seed: hash(seed, index, 0x51ed_270b), count: 0 }
    }

    /// The next 32 bits.
    pub fn bits(&mut self) -> u32 {
        self.count = self.count.wrapping_add(1);
        mix(self.seed ^ mix(self.count))
    }

    /// 0 included, 1 excluded.
    pub fn unit(&mut self) -> f32 {
        unit(self.bits())
    }

    /// Evenly between two numbers.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }

    /// A bell around 0: the sum of three even numbers, −1..1, standard deviation 1/3.
    pub fn bell(&mut self) -> f32 {
        (self.unit() + self.unit() + self.unit()) * (2.0 / 3.0) - 1.0
    }

    /// An angle, radians.
    pub fn angle(&mut self) -> f32 {
        self.unit() * std::f32::consts::TAU
    }

    /// A size between two, with many small ones: the number of things larger than r falls as r to the −`power`.
    pub fn size(&mut self, small: f32, large: f32, power: f32) -> f32 {
        let (low, high) = (libm::powf(small, -power), libm::powf(large, -power));
        libm::powf(low + (high - low) * self.unit(), -1.0 / power)
    }
}
