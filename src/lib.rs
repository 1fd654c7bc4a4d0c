//! Terrane: the renderer and the measuring.

pub mod content;
