//! The one integration-test binary.

mod content;
mod house;
mod library;
mod render;
mod skip;
mod tint;
