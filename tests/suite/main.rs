//! The one integration-test binary.

mod content;
mod house;
mod skip;
mod tint;
