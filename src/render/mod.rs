//! Pictures of terrain, headless, through wgpu.
pub mod air;
mod camera;
mod error;
pub mod geometry;
mod height_field;
mod image;
pub mod light;
mod progress;

pub use camera::{Camera, View, sun_direction};
pub use error::{RenderError, Result};
pub use height_field::HeightField;
pub use image::Image;
pub use progress::{Phase, Progress};
