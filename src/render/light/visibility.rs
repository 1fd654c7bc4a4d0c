//! How much of the sky each place sees, and from where it comes.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, Vec3};
use rayon::prelude::*;

use super::horizon::{Horizons, Land};

/// The sky over every texel.
#[derive(Clone, Debug)]
pub struct SkyVisibility {
    /// (1/π) ∫ ω dω over the sky that the place sees, row by row. Its dot product with a surface's normal is the part of
    /// an even sky's light that the surface gets, exactly, as long as no visible sky lies behind the surface; an open
    /// plain has (0, 1, 0).
    pub vectors: Vec<Vec3>,
}

/// Sweeps the map in `directions` azimuths (8 or 16 are enough for hills). `done` is called with finished lines.
#[must_use]
pub fn sky_visibility(land: Land<'_>, directions: u32, done: &(dyn Fn(u64) + Sync)) -> SkyVisibility {
    let mut vectors = vec![Vec3::ZERO; land.field.texels().len()];
    for azimuth in azimuths(directions) {
        let horizons = Horizons::new(land, azimuth, done);
        vectors.par_iter_mut().zip(&horizons.tangents).for_each(|(vector, &tangent)| {
            *vector += sector(azimuth, f64::from(tangent), TAU / f64::from(directions));
        });
    }
    SkyVisibility { vectors }
}

/// Lines of all sweeps: what `done` of [`sky_visibility`] adds up to.
#[must_use]
pub(super) fn sky_lines(land: Land<'_>, directions: u32) -> u64 {
    azimuths(directions).map(|azimuth| Horizons::lines(land, azimuth)).sum()
}

/// Half a step off the axes, so that the lines of no direction run along a row of texels.
fn azimuths(directions: u32) -> impl Iterator<Item = DVec2> {
    (0..directions).map(move |i| DVec2::from_angle(TAU * (f64::from(i) + 0.5) / f64::from(directions)))
}

/// (1/π) ∫ ω dω over a sector of azimuth of the given width, from the horizon to the zenith. The sky ends at the
/// horizontal, however far a slope falls off.
fn sector(azimuth: DVec2, tangent: f64, width: f64) -> Vec3 {
    let tangent = tangent.max(0.0);
    // sin 2h / 2 and cos² h of the horizon's angle h.
    let (sine, cosine) = (tangent / (1.0 + tangent * tangent), 1.0 / (1.0 + tangent * tangent));
    let flat = PI / 4.0 - tangent.atan() / 2.0 - sine / 2.0;
    let up = cosine / 2.0;
    (glam::DVec3::new(azimuth.x * flat, up, azimuth.y * flat) * (width / PI)).as_vec3()
}
