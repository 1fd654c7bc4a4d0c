//! Rays against a height map on a graphics device: what `terrane measure` times and what the tests hold to the reference.
//!
//! ```text
//! Heights --Placed--> textures      the map and its bounds: `terrane_shaderlib::relief`
//! Segment --Setup---> DeviceRay     cut to where the ground can be, in f32 from a whole cell
//! Method  --Tracer--> Traced        WGSL of the library around one entry point
//! points  --Lighter--> Seen         the same for shadow and occlusion
//! ```

mod clock;
mod lighting;
mod method;
mod setup;
mod shader;
mod texture;
mod tracer;

pub use lighting::{LIFT, Lighter, Lighting, Scene, Seen, Turn};
pub use method::Method;
pub use setup::Segment;
pub use shader::shader;
pub use tracer::{Outcome, Traced, Tracer};
