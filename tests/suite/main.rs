//! The one integration-test binary.

mod house;
mod render;
mod skip;
mod tint;
