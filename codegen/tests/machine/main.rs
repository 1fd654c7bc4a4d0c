//! The machine against independent references: `std`, `glam`, the same programs written in Rust, and itself.

mod acceptance;
mod builtins;
mod control;
mod errors;
mod integers;
mod library;
mod memory;
mod probe;
mod random;
mod rounding;
mod speed;
mod support;
mod textures;
