//! The one integration-test binary.

mod content;
mod house;
mod library;
mod random;
mod render;
mod skip;
mod tint;
