//! Terrane: the makers of textures, the renderer, and rays against relief.

pub mod content;
pub mod file;
pub mod measure;
pub mod relief;
pub mod render;
pub mod scene;
