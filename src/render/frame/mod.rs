//! One picture on the device: what is bound, what is drawn, what comes back.

mod displaced;
mod full_screen;
mod group;
mod objects;
mod readback;
mod resolve;
mod targets;
mod terrain;
mod texture;
mod uniform;

pub(super) use displaced::Displaced;
pub(super) use full_screen::FullScreen;
pub(super) use group::{Bound, Tables};
pub(super) use objects::ObjectsUniform;
pub(super) use readback::{read_depth, read_halves};
pub(super) use resolve::resolve;
pub(super) use targets::Targets;
pub(super) use terrain::{TerrainDraw, TerrainPipeline};
pub(super) use uniform::ViewUniform;
