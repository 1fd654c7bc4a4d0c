//! The one integration-test binary.

mod house;
mod skip;
mod tint;
