//! Rays against a height map on a graphics device: what `terrane measure` times and what the tests hold to the reference.
//!
//! ```text
//! Heights --Placed--> textures      the map and its bounds: `terrane_shaderlib::relief`
//! Segment --Setup---> DeviceRay     cut to where the ground can be, in f32 from a whole cell
//! Method  --Tracer--> Traced        WGSL of the library around one entry point
//! ```

mod clock;
mod map;
mod setup;
mod shader;
pub(crate) mod texture;
mod tracer;

pub use map::map;
pub use setup::Segment;
pub use shader::shader;
pub use tracer::{Outcome, Traced, Tracer};
