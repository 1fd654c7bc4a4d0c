//! A picture to be taken.

use super::{Object, Terrain};
use crate::diagnostic::SourceId;

/// A picture to be taken.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The file.
    pub source: SourceId,
    /// Project-relative path.
    pub path: String,
    /// File stem.
    pub name: String,
    /// What the author says of it.
    pub doc: String,
    /// Its terrain.
    pub terrain: Terrain,
    /// Width and height in pixels.
    pub image: (u32, u32),
    /// Where from, where to.
    pub camera: Camera,
    /// Degrees: clockwise from north (−z), and above the horizon.
    pub sun: Sun,
    /// Preetham's turbidity, 1.8..10: 2 is arctic air, 10 is haze.
    pub turbidity: f32,
    /// Stops.
    pub exposure: f32,
    /// What stands on the terrain.
    pub objects: Vec<Object>,
}

/// Metres from the terrain's north-west corner (x east, y up, z south) and degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Eye.
    pub eye: [f32; 3],
    /// A point in the middle of the picture.
    pub target: [f32; 3],
    /// Vertical field of view.
    pub fov: f32,
}

/// Direction to the sun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// Degrees clockwise from north.
    pub azimuth: f32,
    /// Degrees above the horizon.
    pub elevation: f32,
}
