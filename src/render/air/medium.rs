//! What the air consists of.

use glam::DVec3;

/// Metres from the planet's centre to height 0.
pub const PLANET_RADIUS: f64 = 6_360e3;
/// Metres from the planet's centre to where the air ends.
pub const TOP_RADIUS: f64 = 6_460e3;

/// Cosine-weighted mean of the haze's phase function. Hillaire 2020, table 1.
const HAZE_FORWARD: f64 = 0.8;
/// Share of the light that haze scatters and does not absorb: between clean and average continental air, 0.97 and 0.93 at
/// 550 nm (Hess, Koepke and Schult, "Optical Properties of Aerosols and Clouds", 1998, table 4).
const HAZE_ALBEDO: f64 = 0.95;
/// Wavelengths in µm that stand for red, green and blue: with them a thin sky and the sun through one to five atmospheres
/// have the colours that the whole spectrum gives in linear Rec. 709, to a few percent. (Bruneton 2008 has 0.68 for red,
/// which makes a thin sky too blue by a fifth.)
const WAVELENGTHS: DVec3 = DVec3::new(0.650, 0.550, 0.440);
/// Molecules' scattering per metre at height 0. Hillaire 2020, table 1; red moved by λ^−4.08.
const RAYLEIGH: DVec3 = DVec3::new(6.970e-6, 13.558e-6, 33.1e-6);
/// Ozone's absorption per metre where it is densest. Hillaire 2020, table 1; red moved along the Chappuis band.
const OZONE: DVec3 = DVec3::new(1.2e-6, 1.881e-6, 0.085e-6);

/// Coefficients per metre at height 0, and how they thin out.
#[derive(Clone, Copy, Debug)]
pub struct Medium {
    /// Scattering by molecules.
    pub rayleigh: DVec3,
    /// Scattering by haze.
    pub haze: DVec3,
    /// Scattering and absorption by haze.
    pub haze_extinction: DVec3,
}

/// The medium at one height, per metre.
#[derive(Clone, Copy, Debug)]
pub struct Local {
    /// Scattering by molecules.
    pub rayleigh: DVec3,
    /// Scattering by haze.
    pub haze: DVec3,
    /// All that takes light away.
    pub extinction: DVec3,
}

impl Medium {
    /// Metres over which the molecules' density falls by e.
    pub const RAYLEIGH_HEIGHT: f64 = 8_000.0;
    /// Metres over which the haze's density falls by e: 1 / (0.8333/km) (Preetham 1999, A.3).
    pub const HAZE_HEIGHT: f64 = 1_200.0;

    /// Air of a turbidity: the optical depth of the whole air over that of its molecules, 1.8 to 10.
    ///
    /// The haze's optical depth is Ångström's β λ^−1.3 with β = 0.04608 T − 0.04586 (Preetham 1999, A.1).
    #[must_use]
    pub fn clear(turbidity: f64) -> Self {
        let beta = (0.04608 * turbidity - 0.04586).max(0.0);
        let haze_extinction =
            DVec3::from(WAVELENGTHS.to_array().map(|micro| beta * micro.powf(-1.3))) / Self::HAZE_HEIGHT;
        Self { rayleigh: RAYLEIGH, haze: haze_extinction * HAZE_ALBEDO, haze_extinction }
    }

    /// The medium at a height in metres.
    #[must_use]
    pub fn at(&self, height: f64) -> Local {
        let height = height.max(0.0);
        let (molecules, haze) = ((-height / Self::RAYLEIGH_HEIGHT).exp(), (-height / Self::HAZE_HEIGHT).exp());
        // A tent of ±15 km around 25 km.
        let ozone = (1.0 - (height - 25e3).abs() / 15e3).max(0.0);
        let extinction = self.rayleigh * molecules + self.haze_extinction * haze + OZONE * ozone;
        Local { rayleigh: self.rayleigh * molecules, haze: self.haze * haze, extinction }
    }
}

/// Rayleigh's phase function, per steradian.
#[must_use]
pub(super) fn rayleigh_phase(cosine: f64) -> f64 {
    3.0 / (16.0 * std::f64::consts::PI) * (1.0 + cosine * cosine)
}

/// The haze's phase function, per steradian: Cornette and Shanks, "Physically reasonable analytic expression for the
/// single-scattering phase function", 1992.
#[must_use]
pub(super) fn haze_phase(cosine: f64) -> f64 {
    let g = HAZE_FORWARD;
    let scale = 3.0 / (8.0 * std::f64::consts::PI) * (1.0 - g * g) / (2.0 + g * g);
    scale * (1.0 + cosine * cosine) / (1.0 + g * g - 2.0 * g * cosine).powf(1.5)
}

/// Distance from radius `r` along a direction whose cosine to the vertical is `mu` to the sphere of radius `to` that lies
/// around it, in metres.
#[must_use]
pub(super) fn distance_up(r: f64, mu: f64, to: f64) -> f64 {
    -r * mu + (r * r * (mu * mu - 1.0) + to * to).max(0.0).sqrt()
}

/// Distance to the ground, if the ray meets it.
#[must_use]
pub(super) fn distance_down(r: f64, mu: f64) -> Option<f64> {
    let discriminant = r * r * (mu * mu - 1.0) + PLANET_RADIUS * PLANET_RADIUS;
    (mu < 0.0 && discriminant >= 0.0).then(|| (-r * mu - discriminant.sqrt()).max(0.0))
}
