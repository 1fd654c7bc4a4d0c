//! The sky by direction, as a texture.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;
use rayon::prelude::*;

use super::atmosphere::Atmosphere;

/// Texels on azimuth and elevation.
pub const SKY_TEXELS: [u32; 2] = [192, 256];

/// Radiance seen from one height. Hillaire 2020, section 5.3: rows crowd at the horizon. Columns go from the sun's azimuth
/// to the opposite one and crowd at the sun; the other half of the sky is the mirror image.
#[derive(Clone, Debug)]
pub struct SkyTable {
    /// Radiance for a sun of irradiance 1, row by row from the nadir to the zenith.
    pub texels: Vec<DVec3>,
    sun: DVec3,
}

impl SkyTable {
    /// The sky at a height in metres. `irradiance` is what it gives to flat land around.
    #[must_use]
    pub fn new(atmosphere: &Atmosphere, height: f64, irradiance: DVec3) -> Self {
        let [columns, rows] = SKY_TEXELS;
        let texel = |index: u32| {
            let (x, y) = (index % columns, index / columns);
            let direction = direction(
                f64::from(x) / f64::from(columns - 1),
                2.0 * f64::from(y) / f64::from(rows - 1) - 1.0,
                atmosphere.sun(),
            );
            atmosphere.radiance(height, direction, irradiance)
        };
        Self { texels: (0..columns * rows).into_par_iter().map(texel).collect(), sun: atmosphere.sun() }
    }

    /// Radiance of a direction, as the shader interpolates it.
    #[must_use]
    pub fn radiance(&self, direction: DVec3) -> DVec3 {
        let [columns, rows] = SKY_TEXELS;
        let flat = |v: DVec3| v.with_y(0.0).try_normalize().unwrap_or(DVec3::X);
        let azimuth = flat(direction).dot(flat(self.sun)).clamp(-1.0, 1.0).acos();
        let elevation = direction.y.clamp(-1.0, 1.0).asin();
        let v = elevation.signum() * (elevation.abs() / FRAC_PI_2).sqrt();
        let x = (azimuth / PI).sqrt() * f64::from(columns - 1);
        let y = (v * 0.5 + 0.5) * f64::from(rows - 1);
        let (i, j) = ((x as u32).min(columns - 2), (y as u32).min(rows - 2));
        let (s, t) = (x - f64::from(i), y - f64::from(j));
        let texel = |i: u32, j: u32| self.texels[(j * columns + i) as usize];
        texel(i, j).lerp(texel(i + 1, j), s).lerp(texel(i, j + 1).lerp(texel(i + 1, j + 1), s), t)
    }
}

/// `u` is 0 towards the sun and 1 away from it; `v` is −1 at the nadir, 0 at the horizontal, 1 at the zenith.
fn direction(u: f64, v: f64, sun: DVec3) -> DVec3 {
    let azimuth = sun.z.atan2(sun.x) + u * u * PI;
    let elevation = v * v.abs() * FRAC_PI_2;
    DVec3::new(azimuth.cos() * elevation.cos(), elevation.sin(), azimuth.sin() * elevation.cos())
}
