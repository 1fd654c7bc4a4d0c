//! The one integration-test binary.

mod content;
mod house;
mod render;
mod skip;
mod tint;
