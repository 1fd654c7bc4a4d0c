//! Rays against a height map on a graphics device: what `terrane measure` times and what the tests hold to the reference.
//!
//! ```text
//! Heights --Placed--> textures      the map and its quadtree, filled up to powers of two
//! Segment --Setup---> DeviceRay     cut to where the ground can be, in f32 from a whole cell
//! Method  --Tracer--> Traced        WGSL of the library around one entry point
//! ```

mod method;
mod placed;
mod setup;
mod tracer;

pub use method::Method;
pub use placed::{Placed, Unplaceable};
pub use setup::Segment;
pub use tracer::{Outcome, Traced, Tracer, shader};
