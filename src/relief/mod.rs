//! Rays against a height map on a graphics device: what `terrane measure` times and what the tests hold to the reference.
//!
//! ```text
//! Heights --Placed--> textures      the map and its bounds: `terrane_shaderlib::relief`
//! Segment --Setup---> DeviceRay     cut to where the ground can be, in f32 from a whole cell
//! Method  --Tracer--> Traced        WGSL of the library around two entry points
//! Heights --Built---> textures      the same as `planes`, made on the device; `BuiltPyramid` is the same as `Pyramid`
//! points  --Lighter--> Seen         the same for shadow and occlusion
//! ```

mod build;
mod clock;
mod lighting;
mod map;
mod sent;
mod setup;
mod shader;
pub(crate) mod texture;
mod tracer;

pub use build::{Built, BuiltPyramid};
pub use clock::Timing;
pub use lighting::{LIFT, Lighter, Lighting, Scene, Seen, Turn};
pub use map::{bytes, map};
pub use sent::Sent;
pub use setup::{DeviceRay, Segment, Setup};
pub use shader::{shader, tiled_shader};
pub use tracer::{Outcome, Traced, Tracer};
