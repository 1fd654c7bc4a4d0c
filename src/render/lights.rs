//! Exposure and white balance: from light to what a picture stores.

use glam::{DVec3, Vec3};

use super::air::{Atmosphere, Daylight};

/// Rec. 709 luminance of a linear colour.
#[must_use]
pub fn luminance(colour: DVec3) -> f64 {
    colour.dot(DVec3::new(0.2126, 0.7152, 0.0722))
}

/// How far a photographer's eye has adapted to the colour of the light: 0 keeps every cast, 1 makes white white.
const ADAPTATION: f64 = 0.6;

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
    /// Measures the light over terrain between two heights in metres; `exposure` in stops on top of the base.
    ///
    /// The base exposure is the photographer's: a grey card of 18 % under the metered light comes out as middle grey.
    #[must_use]
    pub fn new(atmosphere: &Atmosphere, [low, high]: [f32; 2], exposure: f64) -> Self {
        let daylight = Daylight::new(atmosphere, f64::from(low));
        let metered = daylight.metered(atmosphere.sun().y);
        let bright = luminance(metered).max(1e-6);
        let balance = (metered / bright).max(DVec3::splat(1e-3)).powf(-ADAPTATION);
        let scale = balance * (std::f64::consts::PI / bright * exposure.exp2());
        Self { low: daylight, sun_high: atmosphere.sun_irradiance(f64::from(high)), scale }
    }

    /// Radiance or irradiance as the shaders see it.
    #[must_use]
    pub fn expose(&self, light: DVec3) -> Vec3 {
        (light * self.scale).as_vec3()
    }
}
