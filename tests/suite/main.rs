//! The one integration-test binary.

mod content;
mod embed;
mod house;
mod library;
mod random;
mod render;
mod skip;
mod tint;
