//! Light at terrain scale, computed once per scene: the sun's shadow and the part of the sky that each place sees.

mod horizon;
mod map;
mod visibility;

pub use horizon::{Horizons, Land, OPEN};
pub use map::{LightMap, LightSettings, light_map};
pub use visibility::{SkyVisibility, sky_visibility};
