//! The sun's disc above the horizon.

use std::f64::consts::PI;

use super::Visibility;

/// A sun with a disc. The disc is that of all (x, y) with x² + y² ≤ 1, where x is an azimuth and y an elevation, both
/// counted from the middle: their tangents over `radius`, the azimuth's times the cosine of the middle's elevation. So its
/// vertical chords lie in vertical planes. It is round as long as the radius is a small angle and the sun not overhead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// The way to it over the ground, of length 1.
    pub towards: [f64; 2],
    /// Tangent of its middle's elevation.
    pub tangent: f64,
    /// Tangent of its radius.
    pub radius: f64,
}

impl Sun {
    /// From angles in degrees: azimuth from +x to +y, elevation, radius.
    #[must_use]
    pub fn new(azimuth: f64, elevation: f64, radius: f64) -> Self {
        let (sine, cosine) = azimuth.to_radians().sin_cos();
        Self { towards: [cosine, sine], tangent: elevation.to_radians().tan(), radius: radius.to_radians().tan() }
    }

    /// The way over the ground, of length 1, to a chord of the disc.
    #[must_use]
    pub fn chord(&self, x: f64) -> [f64; 2] {
        let aside = x * self.radius * self.tangent.hypot(1.0);
        let length = aside.hypot(1.0);
        let [a, b] = self.towards;
        [(a - aside * b) / length, (b + aside * a) / length]
    }

    /// How high on the disc a line of sight meets it, as y; of the tangent of its elevation.
    #[must_use]
    pub fn height(&self, tangent: f64) -> f64 {
        if tangent.is_infinite() {
            return tangent;
        }
        (tangent - self.tangent) / (1.0 + tangent * self.tangent) / self.radius
    }

    /// The tangent of the elevation of a y.
    #[must_use]
    pub fn tangent_at(&self, y: f64) -> f64 {
        (self.tangent + y * self.radius) / (1.0 - self.tangent * y * self.radius)
    }
}

impl Visibility<'_> {
    /// The share of the sun's disc that is seen from a point: chords by Gauss's rule for a weight of √(1 − x²), each seen
    /// above its own horizon.
    #[must_use]
    pub fn sun_share(&self, from: [f64; 3], sun: &Sun, chords: u32, reach: f64) -> f64 {
        let step = PI / f64::from(chords + 1);
        let part = |index: u32| {
            let (half, x) = (f64::from(index) * step).sin_cos();
            let least = sun.tangent_at(-half).max(0.0);
            let horizon = sun.height(self.horizon_above(least, from, sun.chord(x), reach));
            let seen = ((half - horizon) / (2.0 * half)).clamp(0.0, 1.0);
            2.0 / f64::from(chords + 1) * half * half * seen
        };
        (1..=chords).map(part).sum()
    }
}
