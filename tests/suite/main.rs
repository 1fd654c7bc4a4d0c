//! The one integration-test binary.

mod content;
mod embed;
mod emitted;
mod house;
mod library;
mod random;
mod render;
mod skip;
mod tint;
