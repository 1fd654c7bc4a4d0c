//! The atmosphere: the sun's colour, the sky, the light that it gives, and the haze before distant ground, all from one
//! medium, so that they agree.
//!
//! Sources: Bruneton and Neyret, "Precomputed Atmospheric Scattering", EGSR 2008 (medium, transmittance table); Hillaire,
//! "A Scalable and Production Ready Sky and Atmosphere Rendering Technique", EGSR 2020 (multiple scattering, tables by
//! direction and by camera cell); Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999
//! (turbidity). Everything is computed on the CPU in f64; shaders only read tables.

mod aerial;
mod atmosphere;
mod light;
mod march;
mod medium;
mod multiple;
mod sky;
mod transmittance;

pub use aerial::{AERIAL_CELLS, Aerial};
pub use atmosphere::Atmosphere;
pub use light::{Daylight, Harmonics, SUN_RADIUS};
pub use medium::{Medium, PLANET_RADIUS, TOP_RADIUS};
pub use sky::{SKY_TEXELS, SkyTable};
