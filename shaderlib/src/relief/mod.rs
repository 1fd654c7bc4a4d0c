//! What the methods of `wgsl/relief` read: a map and its bounds as textures, and the words of its `ReliefField`.
//!
//! A map is filled up to powers of two. Its heights are a texture with mips; the bounds of all mips stand in one image, each
//! level where a shift of its cells finds it (see [`Field::corner`]).

mod atlas;
mod changed;
mod coarse;
mod cones;
mod dirty;
mod displacement;
mod family;
mod field;
mod method;
mod mips;
mod patches;
mod placed;
mod plane;
mod strip;
mod texture;
mod update;

pub use coarse::{COARSE, LARGE, texels as coarse_texels};
pub use dirty::{Extent, Region, around, halved, inside};
pub use displacement::{Displacement, Undefined};
pub use family::MethodError;
pub use field::Field;
pub use method::{Method, Platform};
pub use placed::{Bounds, Placed, Unplaceable, planes};
pub use plane::{Plane, Words};
pub use strip::{wide_corners, wide_places};
pub use texture::MapTexture;
