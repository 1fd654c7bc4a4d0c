//! Terrane: the renderer and the measuring.
pub mod render;
