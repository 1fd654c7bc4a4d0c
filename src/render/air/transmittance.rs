//! How much light crosses the air from a place to its end.

use glam::DVec3;
use rayon::prelude::*;

use super::medium::{Medium, PLANET_RADIUS, TOP_RADIUS, distance_up};

const COSINES: usize = 256;
const RADII: usize = 64;
/// Steps of a ray; the trapezoidal rule over them is good to about 1e-4 at the horizon.
const STEPS: usize = 200;

/// A table by radius and cosine to the vertical, in the mapping of Bruneton 2008, section 4.
#[derive(Clone, Debug)]
pub(super) struct Transmittance {
    texels: Vec<DVec3>,
}

impl Transmittance {
    /// Integrates every entry.
    #[must_use]
    pub(super) fn new(medium: &Medium) -> Self {
        let entry = |index: usize| {
            let (x, y) = (index % COSINES, index / COSINES);
            let (r, mu) = unmap(x as f64 / (COSINES - 1) as f64, y as f64 / (RADII - 1) as f64);
            integrate(medium, r, mu)
        };
        Self { texels: (0..COSINES * RADII).into_par_iter().map(entry).collect() }
    }

    /// To the end of the air, as if the planet were not in the way.
    #[must_use]
    pub(super) fn to_top(&self, r: f64, mu: f64) -> DVec3 {
        let (x, y) = map(r, mu);
        let (x, y) = (x * (COSINES - 1) as f64, y * (RADII - 1) as f64);
        let (i, j) = ((x as usize).min(COSINES - 2), (y as usize).min(RADII - 2));
        let (s, t) = (x - i as f64, y - j as f64);
        let texel = |i: usize, j: usize| self.texels[j * COSINES + i];
        texel(i, j).lerp(texel(i + 1, j), s).lerp(texel(i, j + 1).lerp(texel(i + 1, j + 1), s), t)
    }
}

/// Distance from the planet's surface to the horizon that a place at radius `r` sees.
fn horizon_distance(r: f64) -> f64 {
    (r * r - PLANET_RADIUS * PLANET_RADIUS).max(0.0).sqrt()
}

fn map(r: f64, mu: f64) -> (f64, f64) {
    let (far, near) = (horizon_distance(r) + horizon_distance(TOP_RADIUS), TOP_RADIUS - r);
    let x = (distance_up(r, mu, TOP_RADIUS) - near) / (far - near);
    (x.clamp(0.0, 1.0), horizon_distance(r) / horizon_distance(TOP_RADIUS))
}

fn unmap(x: f64, y: f64) -> (f64, f64) {
    let top = horizon_distance(TOP_RADIUS);
    let r = (PLANET_RADIUS * PLANET_RADIUS + (y * top) * (y * top)).sqrt();
    let (far, near) = (y * top + top, TOP_RADIUS - r);
    let distance = near + x * (far - near);
    let mu = if distance <= 0.0 {
        1.0
    } else {
        (TOP_RADIUS * TOP_RADIUS - r * r - distance * distance) / (2.0 * r * distance)
    };
    (r, mu.clamp(-1.0, 1.0))
}

fn integrate(medium: &Medium, r: f64, mu: f64) -> DVec3 {
    let step = distance_up(r, mu, TOP_RADIUS) / STEPS as f64;
    let mut depth = DVec3::ZERO;
    for i in 0..=STEPS {
        let t = step * i as f64;
        let height = (r * r + t * t + 2.0 * r * mu * t).sqrt() - PLANET_RADIUS;
        let weight = if i == 0 || i == STEPS { 0.5 } else { 1.0 };
        depth += medium.at(height).extinction * (weight * step);
    }
    (-depth).exp()
}
