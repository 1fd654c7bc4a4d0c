//! Terrane: the makers of textures and the renderer.

pub mod content;
pub mod file;
pub mod render;
pub mod scene;
