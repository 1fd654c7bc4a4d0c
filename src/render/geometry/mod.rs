//! Terrain as geometry: a quadtree whose visible leaves are copies of one grid of 33 × 33 vertices.
//!
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, section 5.4. Neighbouring
//! leaves differ by one level at most; where they do, the finer one leaves out every second vertex of the shared side.
//! Two sides of a leaf touch leaves with the same parent, so only two can meet a coarser one: 9 index lists are enough.

mod bounds;
mod cull;
mod grid;
mod select;
mod tile;

pub use bounds::{Bounds, CELLS};
pub use cull::visible;
pub use grid::{Grid, VERTICES};
pub use select::{Patch, Side, select};
pub use tile::Tile;
