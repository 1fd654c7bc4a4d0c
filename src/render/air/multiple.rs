//! Light that has been scattered more than once.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use rayon::prelude::*;

use super::march::{Gathered, Ray};
use super::medium::{Medium, PLANET_RADIUS, TOP_RADIUS, distance_down, distance_up};
use super::transmittance::Transmittance;

const COSINES: usize = 32;
const HEIGHTS: usize = 32;
const DIRECTIONS: usize = 8;
const STEPS: usize = 20;

/// Radiance from all orders above the first for a sun of irradiance 1, the same in all directions: Hillaire 2020,
/// section 5.5. By the cosine of the sun's zenith angle and by height.
#[derive(Clone, Debug)]
pub(super) struct Multiple {
    texels: Vec<DVec3>,
}

impl Multiple {
    /// Integrates every entry. `ground` is the planet's mean albedo.
    #[must_use]
    pub(super) fn new(medium: &Medium, transmittance: &Transmittance, ground: DVec3) -> Self {
        let entry = |index: usize| {
            let (x, y) = (index % COSINES, index / COSINES);
            let sun = 2.0 * x as f64 / (COSINES - 1) as f64 - 1.0;
            // Quadratic: half of the entries lie in the lowest quarter, where the haze is.
            let height = (TOP_RADIUS - PLANET_RADIUS - 1.0) * (y as f64 / (HEIGHTS - 1) as f64).powi(2);
            Probe { medium, transmittance, ground, height, sun }.radiance()
        };
        Self { texels: (0..COSINES * HEIGHTS).into_par_iter().map(entry).collect() }
    }

    /// At a height in metres, under a sun whose zenith angle has that cosine.
    #[must_use]
    pub(super) fn at(&self, height: f64, sun: f64) -> DVec3 {
        let x = (sun * 0.5 + 0.5).clamp(0.0, 1.0) * (COSINES - 1) as f64;
        let y = (height / (TOP_RADIUS - PLANET_RADIUS)).clamp(0.0, 1.0).sqrt() * (HEIGHTS - 1) as f64;
        let (i, j) = ((x as usize).min(COSINES - 2), (y as usize).min(HEIGHTS - 2));
        let (s, t) = (x - i as f64, y - j as f64);
        let texel = |i: usize, j: usize| self.texels[j * COSINES + i];
        texel(i, j).lerp(texel(i + 1, j), s).lerp(texel(i, j + 1).lerp(texel(i + 1, j + 1), s), t)
    }
}

/// One place in the air under one sun.
struct Probe<'a> {
    medium: &'a Medium,
    transmittance: &'a Transmittance,
    ground: DVec3,
    height: f64,
    sun: f64,
}

impl Probe<'_> {
    /// Second-order light over 1 − the share that each further order keeps.
    fn radiance(&self) -> DVec3 {
        let (mut second, mut kept) = (DVec3::ZERO, DVec3::ZERO);
        for i in 0..DIRECTIONS * DIRECTIONS {
            let up = 1.0 - 2.0 * ((i / DIRECTIONS) as f64 + 0.5) / DIRECTIONS as f64;
            let azimuth = TAU * ((i % DIRECTIONS) as f64 + 0.5) / DIRECTIONS as f64;
            let flat = (1.0 - up * up).sqrt();
            let (light, share) = self.gather(DVec3::new(flat * azimuth.cos(), up, flat * azimuth.sin()));
            second += light;
            kept += share;
        }
        let mean = 1.0 / (DIRECTIONS * DIRECTIONS) as f64;
        second * mean / (DVec3::ONE - kept * mean)
    }

    fn gather(&self, direction: DVec3) -> (DVec3, DVec3) {
        let sun = DVec3::new((1.0 - self.sun * self.sun).max(0.0).sqrt(), self.sun, 0.0);
        let start = PLANET_RADIUS + self.height;
        let ground = distance_down(start, direction.y);
        let step = ground.unwrap_or_else(|| distance_up(start, direction.y, TOP_RADIUS)) / STEPS as f64;
        let ray = Ray::new(self.height, direction);
        let (mut light, mut share) = (Gathered::NOTHING, Gathered::NOTHING);
        for i in 0..STEPS {
            let (radius, vertical) = ray.at(step * (i as f64 + 0.5));
            let air = self.medium.at(radius - PLANET_RADIUS);
            let scattering = air.rayleigh + air.haze;
            let lit = sunlight(self.transmittance, radius, vertical.dot(sun));
            light.cross(&air, scattering * lit / (4.0 * PI), step);
            share.cross(&air, scattering, step);
        }
        if let Some(distance) = ground {
            let cosine = ray.at(distance).1.dot(sun);
            let lit = sunlight(self.transmittance, PLANET_RADIUS, cosine) * cosine.max(0.0);
            light.light += light.transmittance * lit * self.ground / PI;
        }
        (light.light, share.light)
    }
}

/// Share of the sun's light that reaches a radius, none behind the planet. The disc sets over its own width
/// (Bruneton 2017, "Precomputed Atmospheric Scattering: a New Implementation", GetTransmittanceToSun).
#[must_use]
pub(super) fn sunlight(transmittance: &Transmittance, radius: f64, cosine: f64) -> DVec3 {
    let sine = (PLANET_RADIUS / radius).min(1.0);
    let horizon = -(1.0 - sine * sine).sqrt();
    let width = sine * super::light::SUN_RADIUS;
    let part = ((cosine - horizon) / (2.0 * width) + 0.5).clamp(0.0, 1.0);
    transmittance.to_top(radius, cosine.max(horizon)) * (part * part * (3.0 - 2.0 * part))
}
