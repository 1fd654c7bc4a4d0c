//! Exposure and white balance: from light to what a picture stores.

use glam::{DVec3, Vec3};

use super::air::{Atmosphere, Daylight};

/// Rec. 709 luminance of a linear colour.
#[must_use]
pub fn luminance(colour: DVec3) -> f64 {
    colour.dot(DVec3::new(0.2126, 0.7152, 0.0722))
}

/// The sun above the air, a black body of 5778 K, in linear Rec. 709 with luminance 1.
const SUN: DVec3 = DVec3::new(1.110, 0.976, 0.913);

/// Radiance that the tone curve takes for the middle of its range.
const MIDDLE_GREY: f64 = 0.18;

/// Mean albedo of land without snow.
const LAND: f64 = 0.12;

/// How far a photographer's eye adapts to the colour of the light outdoors: a low sun stays warm, but less than measured.
pub(super) const ADAPTATION: f64 = 0.6;

/// Lights of a picture, for a sun of irradiance 1 above the air, and what they are multiplied by.
#[derive(Clone, Copy, Debug)]
pub struct Lights {
    /// At the terrain's lowest place.
    pub low: Daylight,
    /// Irradiance of the sun at the terrain's highest place.
    pub sun_high: DVec3,
    /// Exposure times white balance.
    scale: DVec3,
}

impl Lights {
    /// Measures the light over terrain between two heights in metres; `exposure` in stops on top of the base;
    /// `adaptation` is 0 to keep the colour of the light and 1 to make white ground white.
    ///
    /// The base exposure is that of a camera pointed at open, flat land of albedo 0.12: it comes out as middle grey, 0.18.
    #[must_use]
    pub fn new(atmosphere: &Atmosphere, [low, high]: [f32; 2], exposure: f64, adaptation: f64) -> Self {
        let daylight = Daylight::new(atmosphere, f64::from(low));
        let metered = daylight.flat(atmosphere.sun().y) * SUN;
        let bright = luminance(metered).max(1e-6);
        let balance = (metered / bright).max(DVec3::splat(1e-3)).powf(-adaptation);
        let scale = SUN * balance * (MIDDLE_GREY / LAND * std::f64::consts::PI / bright * exposure.exp2());
        Self { low: daylight, sun_high: atmosphere.sun_irradiance(f64::from(high)), scale }
    }

    /// Radiance or irradiance as the shaders see it.
    #[must_use]
    pub fn expose(&self, light: DVec3) -> Vec3 {
        (light * self.scale).as_vec3()
    }
}
