//! Sun and sky as lights on the ground.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;

use super::atmosphere::Atmosphere;

/// Angular radius of the sun in radians.
pub const SUN_RADIUS: f64 = 0.004_675;

/// Rings and sectors of the integral over the sky.
const RINGS: usize = 32;
const SECTORS: usize = 64;

/// Spherical harmonics up to the second order of a light's irradiance: nine coefficients, each a colour.
#[derive(Clone, Copy, Debug)]
pub struct Harmonics(pub [DVec3; 9]);

impl Harmonics {
    /// Irradiance on a surface with that normal.
    #[must_use]
    pub fn irradiance(&self, normal: DVec3) -> DVec3 {
        basis(normal).into_iter().zip(self.0).map(|(weight, colour)| colour * weight).sum()
    }
}

/// What lights the ground, for a sun of irradiance 1 above the air.
#[derive(Clone, Copy, Debug)]
pub struct Daylight {
    /// Irradiance of the sun on a surface that faces it.
    pub sun: DVec3,
    /// Irradiance of the sky on open, flat ground.
    pub sky: DVec3,
    /// Irradiance of the upper half of the sky, the lower half black, on any surface.
    pub harmonics: Harmonics,
}

impl Daylight {
    /// At a height in metres.
    #[must_use]
    pub fn new(atmosphere: &Atmosphere, height: f64) -> Self {
        let mut coefficients = [DVec3::ZERO; 9];
        let mut sky = DVec3::ZERO;
        for (direction, solid_angle) in dome() {
            // Only the upper half is asked for, so what the land below would send does not matter.
            let light = atmosphere.radiance(height, direction, DVec3::ZERO) * solid_angle;
            sky += light * direction.y;
            for (coefficient, weight) in coefficients.iter_mut().zip(basis(direction)) {
                *coefficient += light * weight;
            }
        }
        // The cosine lobe's own coefficients (Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance
        // Environment Maps", SIGGRAPH 2001): π, 2π/3, π/4.
        let lobe = [PI, TAU / 3.0, TAU / 3.0, TAU / 3.0, PI / 4.0, PI / 4.0, PI / 4.0, PI / 4.0, PI / 4.0];
        let harmonics = Harmonics(std::array::from_fn(|i| coefficients[i] * lobe[i]));
        // A bright horizon needs more orders than the second: flat ground, at least, gets exactly its light.
        let exact = sky / harmonics.irradiance(DVec3::Y).max(DVec3::splat(1e-12));
        let harmonics = Harmonics(harmonics.0.map(|colour| colour * exact));
        Self { sun: atmosphere.sun_irradiance(height), sky, harmonics }
    }

    /// Irradiance of sun and sky on open, flat ground under a sun whose elevation has that sine.
    #[must_use]
    pub fn flat(&self, elevation_sine: f64) -> DVec3 {
        self.sun * elevation_sine.max(0.0) + self.sky
    }
}

/// Directions over the upper half of the sky with their solid angles; rings of equal elevation.
fn dome() -> impl Iterator<Item = (DVec3, f64)> {
    (0..RINGS * SECTORS).map(|i| {
        let (ring, sector) = (i / SECTORS, i % SECTORS);
        let (low, high) = (ring as f64 / RINGS as f64 * FRAC_PI_2, (ring + 1) as f64 / RINGS as f64 * FRAC_PI_2);
        let elevation = 0.5 * (low + high);
        let azimuth = (sector as f64 + 0.5) / SECTORS as f64 * TAU;
        let direction = DVec3::new(azimuth.cos() * elevation.cos(), elevation.sin(), azimuth.sin() * elevation.cos());
        (direction, (high.sin() - low.sin()) * TAU / SECTORS as f64)
    })
}

/// Real spherical harmonics with y up; the shader has the same order.
fn basis(d: DVec3) -> [f64; 9] {
    [
        0.282_095,
        0.488_603 * d.y,
        0.488_603 * d.z,
        0.488_603 * d.x,
        1.092_548 * d.x * d.y,
        1.092_548 * d.y * d.z,
        0.315_392 * (3.0 * d.z * d.z - 1.0),
        1.092_548 * d.x * d.z,
        0.546_274 * (d.x * d.x - d.y * d.y),
    ]
}
