//! Light gathered along a ray through the air.

use glam::DVec3;

use super::medium::{Local, PLANET_RADIUS, haze_phase, rayleigh_phase};

/// What a ray has met so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gathered {
    /// Radiance towards the eye.
    pub(super) light: DVec3,
    /// Share of what lies behind that still gets through.
    pub(super) transmittance: DVec3,
}

impl Gathered {
    /// Nothing yet.
    pub(super) const NOTHING: Self = Self { light: DVec3::ZERO, transmittance: DVec3::ONE };

    /// Crosses `length` metres of air that scatters `source` per metre towards the eye. The integral over the step is
    /// exact for constant air (Hillaire 2015, "Physically Based and Unified Volumetric Rendering in Frostbite").
    pub(super) fn cross(&mut self, air: &Local, source: DVec3, length: f64) {
        let through = (-air.extinction * length).exp();
        let extinction = air.extinction.max(DVec3::splat(1e-12));
        self.light += self.transmittance * source * (DVec3::ONE - through) / extinction;
        self.transmittance *= through;
    }
}

/// Single scattering of sunlight at a place, per metre and unit of irradiance.
#[must_use]
pub(super) fn scatter(air: &Local, cosine: f64) -> DVec3 {
    air.rayleigh * rayleigh_phase(cosine) + air.haze * haze_phase(cosine)
}

/// A ray from height `height` (metres) over the planet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    origin: DVec3,
    direction: DVec3,
}

impl Ray {
    /// The planet's centre lies below the ray's origin.
    #[must_use]
    pub(super) fn new(height: f64, direction: DVec3) -> Self {
        Self { origin: DVec3::new(0.0, PLANET_RADIUS + height, 0.0), direction }
    }

    /// Radius in metres and the local vertical after `t` metres.
    #[must_use]
    pub(super) fn at(&self, t: f64) -> (f64, DVec3) {
        let place = self.origin + self.direction * t;
        let radius = place.length();
        (radius, place / radius)
    }
}
