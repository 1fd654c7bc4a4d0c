//! The machine against independent references: `std`, `glam`, the same programs written in Rust, and itself.

mod control;
mod library;
mod support;
