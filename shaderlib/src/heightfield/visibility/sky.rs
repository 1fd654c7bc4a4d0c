//! The sky that a surface sees.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::Visibility;

impl Visibility<'_> {
    /// The share of an even sky's irradiance that reaches a surface with this normal (z up, of length 1): (1/π) ∫ n·ω dω over
    /// the directions that are above the surface, above the horizon of their azimuth, and above the plane of the map. The
    /// azimuths are evenly spaced, from the first on; for each the integral over the elevation is exact.
    #[must_use]
    pub fn sky_share(&self, from: [f64; 3], normal: [f64; 3], azimuths: u32, reach: f64) -> f64 {
        let wedge = |index: u32| {
            let (sine, cosine) = (f64::from(index) * TAU / f64::from(azimuths)).sin_cos();
            let along = normal[0] * cosine + normal[1] * sine;
            let least = (-along / normal[2]).max(0.0);
            wedge(along, normal[2], self.horizon_above(least, from, [cosine, sine], reach))
        };
        (0..azimuths).map(wedge).sum::<f64>() / f64::from(azimuths)
    }
}

/// Twice ∫ (along cos e + up sin e) cos e de, from a horizon of which this is the tangent to the zenith.
fn wedge(along: f64, up: f64, horizon: f64) -> f64 {
    let angle = horizon.atan();
    let (sine, cosine) = angle.sin_cos();
    along * (FRAC_PI_2 - angle - sine * cosine) + up * cosine * cosine
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wedge_is_the_integral_over_its_elevations() {
        for (along, up, horizon) in [(0.0, 1.0, 0.0), (0.6, 0.8, 0.3), (-0.6, 0.8, 2.0)] {
            let first = f64::atan(horizon);
            let step = (FRAC_PI_2 - first) / 4096.0;
            let middle = |index: u32| (f64::from(index) + 0.5).mul_add(step, first);
            let summed: f64 = (0..4096)
                .map(middle)
                .map(|angle| 2.0 * step * angle.cos() * (along * angle.cos() + up * angle.sin()))
                .sum();
            assert!((wedge(along, up, horizon) - summed).abs() < 1e-6, "{along} {up} {horizon}: {summed}");
        }
    }
}
