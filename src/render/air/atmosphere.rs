//! The medium with its tables: radiance of any direction, haze before any distance.

use std::f64::consts::PI;

use glam::DVec3;

use super::march::{Gathered, Ray, scatter};
use super::medium::{Medium, PLANET_RADIUS, TOP_RADIUS, distance_down, distance_up};
use super::multiple::{Multiple, sunlight};
use super::transmittance::Transmittance;

/// Albedo of the land around the terrain: grass, rock and wood from afar.
const GROUND: DVec3 = DVec3::new(0.13, 0.12, 0.09);

/// Steps of a ray to the end of the air.
const STEPS: usize = 48;

/// Air of one turbidity under one sun, whose irradiance above the air is 1.
#[derive(Clone, Debug)]
pub struct Atmosphere {
    medium: Medium,
    transmittance: Transmittance,
    multiple: Multiple,
    sun: DVec3,
}

impl Atmosphere {
    /// Computes the tables. `sun` is the unit vector to the sun.
    #[must_use]
    pub fn new(turbidity: f64, sun: DVec3) -> Self {
        let medium = Medium::clear(turbidity);
        let transmittance = Transmittance::new(&medium);
        let multiple = Multiple::new(&medium, &transmittance, GROUND);
        Self { medium, transmittance, multiple, sun }
    }

    /// The coefficients.
    #[must_use]
    pub fn medium(&self) -> &Medium {
        &self.medium
    }

    /// Unit vector to the sun.
    #[must_use]
    pub fn sun(&self) -> DVec3 {
        self.sun
    }

    /// The sun's irradiance on a surface that faces it, at a height in metres.
    #[must_use]
    pub fn sun_irradiance(&self, height: f64) -> DVec3 {
        sunlight(&self.transmittance, PLANET_RADIUS + height.max(0.0), self.sun.y)
    }

    /// Radiance of the sky, or of the land below the horizon, seen from a height in metres; without the sun's disc.
    /// `sky` is the irradiance that the sky gives to flat land.
    #[must_use]
    pub fn radiance(&self, height: f64, direction: DVec3, sky: DVec3) -> DVec3 {
        let start = PLANET_RADIUS + height.max(0.0);
        let ground = distance_down(start, direction.y);
        let length = ground.unwrap_or_else(|| distance_up(start, direction.y, TOP_RADIUS));
        // Steps grow with the distance: the air near the eye is the densest on most rays.
        let planes = (0..=STEPS).map(|i| length * (i as f64 / STEPS as f64).powi(2));
        let gathered = self.gather(height, direction, planes);
        let Some(distance) = ground else {
            return gathered.light;
        };
        let cosine = Ray::new(height.max(0.0), direction).at(distance).1.dot(self.sun);
        let lit = sunlight(&self.transmittance, PLANET_RADIUS, cosine) * cosine.max(0.0) + sky;
        gathered.light + gathered.transmittance * lit * GROUND / PI
    }

    /// Light scattered into a ray between successive distances in metres.
    #[must_use]
    pub(super) fn gather(&self, height: f64, direction: DVec3, distances: impl IntoIterator<Item = f64>) -> Gathered {
        let mut gathered = Gathered::NOTHING;
        let mut before = None;
        for distance in distances {
            if let Some(from) = before.replace(distance) {
                self.cross(&mut gathered, height, direction, from, distance);
            }
        }
        gathered
    }

    /// Goes on along a ray from one distance to another, in one step.
    pub(super) fn cross(&self, gathered: &mut Gathered, height: f64, direction: DVec3, from: f64, to: f64) {
        let (radius, vertical) = Ray::new(height.max(0.0), direction).at(0.5 * (from + to));
        let above = (radius - PLANET_RADIUS).max(0.0);
        let air = self.medium.at(above);
        let sun = vertical.dot(self.sun);
        let single = scatter(&air, direction.dot(self.sun)) * sunlight(&self.transmittance, radius, sun);
        let source = single + (air.rayleigh + air.haze) * self.multiple.at(above, sun);
        gathered.cross(&air, source, to - from);
    }
}
