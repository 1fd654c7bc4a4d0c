//! The renderer: geometry, light and air against independent references, pictures against the CPU.

mod air;
mod geometry;
mod light;
mod material;
mod objects;
mod picture;
mod tint;
mod world;
