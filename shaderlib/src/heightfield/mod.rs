//! Height fields: the surface, the data that makes rays through it fast, and the exact reference.
//!
//! Positions count in texels from the centre of the first texel, heights in steps of the map. A ray is `origin + t
//! direction`; its direction need not have length 1.

pub mod adversary;
pub mod cones;
mod exact;
mod heights;
pub mod oracle;
pub mod pyramid;
mod quantise;
mod ray;
pub mod visibility;

pub use exact::{first_hit, visible};
pub use heights::{Border, Heights, HeightsError, LARGEST_SIDE, Texels};
pub use quantise::Quantised;
pub use ray::{FixedRay, Hit, Ray};
