//! Terrane: the renderer and the measuring.

pub mod content;
pub mod render;
