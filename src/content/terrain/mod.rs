//! Height maps, made by the forces that make land.
pub mod crags;
pub mod debris;
pub mod dunes;
pub mod flow;
pub mod land;
pub mod mesas;
pub mod mountains;
pub mod river;
pub mod valley;
pub mod water;
